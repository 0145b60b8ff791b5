#pragma once

#include <Eigen/Core>
#include <span>

#include "algo/types/pose.h"

namespace honka {

/// The rigid transform that lays `source_m` onto `target_m`, pairs of equal index, with the least
/// sum of squares (Arun et al. 1987). Pairs that do not fix a rotation, because either side lies on
/// one line or at one place, keep `rotation_if_free`. At least one pair.
[[nodiscard]] Pose3 fit_pose(std::span<const Eigen::Vector3d> target_m,
                             std::span<const Eigen::Vector3d> source_m,
                             const Eigen::Matrix3d& rotation_if_free = Eigen::Matrix3d::Identity());

}  // namespace honka
