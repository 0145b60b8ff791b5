#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/slam/convergence_study.h"

namespace honka::eval {

/// A quarter ellipse of Eq. 26.
struct ConvergenceArc {
  std::string label;
  double shift_m = 0.0, turn_deg = 0.0;
};

/// Starts over shift (columns) and turn (rows), row by row, and the ellipses to draw on them.
struct ConvergenceGrid {
  int columns = 0, rows = 0;
  double shift_step_m = 0.0, turn_step_deg = 0.0;
  std::vector<ConvergencePoint> points;
  std::vector<ConvergenceArc> arcs;
};

/// Nevalainen2021 Fig. 6: mean e with its contours of 0.2 and 0.7 m.
[[nodiscard]] ReportFigure draw_convergence_error(const std::filesystem::path& folder,
                                                  const ConvergenceGrid& grid);
/// The same for the success, with its contours of 90 and 95 %.
[[nodiscard]] ReportFigure draw_convergence_success(const std::filesystem::path& folder,
                                                    const ConvergenceGrid& grid);

/// A frame, and another tilted out of its true place in it.
struct TiltScene {
  double tilt_deg = 0.0;
  std::vector<Eigen::Vector3d> target_m, tilted_m;
};

/// Nevalainen2021 Fig. 7: both frames from the side.
[[nodiscard]] ReportFigure draw_tilt_scene(const std::filesystem::path& folder,
                                           const TiltScene& scene);
/// Mean e and success over the tilt of the start.
[[nodiscard]] ReportFigure draw_tilt_curves(const std::filesystem::path& folder,
                                            const std::vector<ConvergencePoint>& points,
                                            double paper_limit_deg);

}  // namespace honka::eval
