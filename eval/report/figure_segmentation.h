#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// Li2020 Fig. 5: the three stages of Algorithm 1 on one cloud. Local frame, metres; a slice along
/// y = 0 is drawn.
struct SegmentationFigure {
  std::vector<Eigen::Vector3d> original;  ///< (a)
  std::vector<Eigen::Vector3d> kept;      ///< (b) has a neighbour 2 m above it
  std::vector<Eigen::Vector3d> removed;   ///< (b) ground and branches
  std::vector<Eigen::Vector3d> clusters;  ///< (c) points of the final clusters
  std::string protocol;
  double slice_half_width_m = 6.0;
};

[[nodiscard]] ReportFigure draw_segmentation(const std::filesystem::path& folder,
                                             const SegmentationFigure& input);

}  // namespace honka::eval
