#pragma once

#include <Eigen/Core>
#include <vector>

#include "algo/odometry/loam/settings.h"
#include "algo/types/lidar_model.h"
#include "algo/types/sweep.h"

namespace honka {

/// A point of a sweep that registration uses.
struct LoamFeature {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< in the lidar frame at its own time
  double share = 0.0;                                 ///< of the revolution that had passed
  double range_m = 0.0;                               ///< from the lidar
  double curvature = 0.0;                             ///< Zhang2014 Eq. (1)
};

struct LoamFeatures {
  std::vector<LoamFeature> edges;   ///< axis points of stems and what looks like them
  std::vector<LoamFeature> planes;  ///< points of smooth surfaces, mostly the ground
};

/// Evenly picked from the list so that at most `most` are left.
[[nodiscard]] std::vector<LoamFeature> thinned(const std::vector<LoamFeature>& features,
                                               std::size_t most);

/// Edge and plane points of each ring by curvature (Zhang2014, section V.A).
///
/// A sweep is cut into rings and these into runs of returns without a step in depth. A narrow run
/// that stands free before what is behind it is a stem: its two edges give the azimuth and width,
/// its ranges the distance, and the axis of the stem is the feature, the same from every side.
/// Points of wide runs with little curvature are planes, the smoothest of each sector first.
/// Returns of range 0, of unknown lasers, of later echoes and beyond one and a half revolutions
/// are no points.
[[nodiscard]] LoamFeatures extract_loam_features(const Sweep& sweep, const LidarModel& model,
                                                 const LoamFeatureSettings& settings);

}  // namespace honka
