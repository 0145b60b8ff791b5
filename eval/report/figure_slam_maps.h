#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// A map of stems from above: every registration of every frame, and the path of the sensor.
struct SlamMapPanel {
  std::string label;
  std::vector<Eigen::Vector3d> points_m;
  std::vector<Eigen::Vector2d> path_m;
};

/// Maps above one another on one scale, in the manner of Nevalainen2021, Figure 11.
struct SlamMapsFigure {
  std::string name, title, protocol, caption;
  std::vector<SlamMapPanel> panels;  ///< from above
};

/// folder/<name>.png: points black, paths red.
[[nodiscard]] ReportFigure draw_slam_maps(const std::filesystem::path& folder,
                                          const SlamMapsFigure& input);

}  // namespace honka::eval
