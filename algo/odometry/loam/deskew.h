#pragma once

#include <vector>

#include "algo/geometry/se3.h"
#include "algo/odometry/loam/features.h"

namespace honka {

/// Features moved to where the lidar sees them from at the middle of the sweep, when the body
/// moves with `twist_per_sweep` (constant; from start to end of one revolution). Points at share s
/// go by exp((s − 1/2) · twist). As many points as features.
[[nodiscard]] std::vector<Eigen::Vector3d> deskewed(const std::vector<LoamFeature>& features,
                                                    const Twist& twist_per_sweep);

}  // namespace honka
