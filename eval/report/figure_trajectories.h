#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// A curve of a figure: x and y of its points; NaN lifts the pen.
struct Curve {
  std::string label;
  std::vector<Eigen::Vector2d> points;
};

/// Trajectories in the plane, metres; the first is the truth.
struct TrajectoriesFigure {
  std::string name;  ///< of the files
  std::string title, protocol;
  std::vector<Curve> curves;
};

[[nodiscard]] ReportFigure draw_trajectories(const std::filesystem::path& folder,
                                             const TrajectoriesFigure& input);

/// One plot of a figure whose plots lie above one another.
struct CurvesPanel {
  std::string y_label;
  std::vector<Curve> curves;
};

/// Curves over one x axis.
struct CurvesFigure {
  std::string name;
  std::string title, protocol, x_label, caption;
  bool points = false;  ///< marks each point, for a few of them
  std::vector<CurvesPanel> panels;
};

[[nodiscard]] ReportFigure draw_curves(const std::filesystem::path& folder,
                                       const CurvesFigure& input);

/// At most so many of a curve's points, evenly by number, with both ends.
[[nodiscard]] std::vector<Eigen::Vector2d> sampled(const std::vector<Eigen::Vector2d>& points,
                                                   std::size_t limit);

}  // namespace honka::eval
