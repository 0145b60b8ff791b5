#pragma once

#include "algo/odometry/loam/deskew.h"
#include "algo/odometry/loam/feature_map.h"
#include "algo/odometry/loam/features.h"
#include "algo/odometry/loam/settings.h"

namespace honka {

/// The features of a sweep as they lie at its middle, for one guess of the motion.
struct DeskewedFeatures {
  std::vector<Eigen::Vector3d> edges_m, planes_m;  ///< lidar frame; one for each feature

  DeskewedFeatures(const LoamFeatures& features, const Twist& twist_per_sweep)
      : edges_m(deskewed(features.edges, twist_per_sweep)),
        planes_m(deskewed(features.planes, twist_per_sweep)) {}
};

/// What key frames have seen, in the odom frame: axes of stems and ground.
struct LoamMap {
  FeatureMap edges, planes;

  explicit LoamMap(const LoamMapSettings& settings);
  /// Adds the features of a sweep whose middle is at `T_odom_lidar`; edges count by the inverse of
  /// their variance.
  void add(const LoamFeatures& features, const DeskewedFeatures& points, const Pose3& T_odom_lidar,
           double edge_noise_m, double azimuth_step_rad);
  void clear();
};

/// S.d. of the axis of a stem across the beam: both its edges are known to a part of the step
/// between two firings.
[[nodiscard]] double edge_grain_m(double range_m, double azimuth_step_rad);

}  // namespace honka
