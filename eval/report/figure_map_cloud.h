#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Li2020 Fig. 1c: the point-cloud map from above and from the side, coloured by height, with the
/// sensor's path and the stems found in it. Map frame, metres.
struct MapCloudFigure {
  std::vector<Eigen::Vector3d> cloud;  ///< of any size: at most 60,000 points are drawn
  std::vector<Eigen::Vector2d> path;
  std::vector<Eigen::Vector2d> stems;
  std::string protocol;
};

[[nodiscard]] ReportFigure draw_map_cloud(const std::filesystem::path& folder,
                                          const MapCloudFigure& input);

}  // namespace honka::eval
