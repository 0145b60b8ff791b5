#pragma once

#include <Eigen/Core>

#include "algo/types/pose.h"

namespace honka {

/// A motion of SE(3): translation part first, rotation vector below. Metres, radians.
using Twist = Eigen::Matrix<double, 6, 1>;

/// exp: R³ → SO(3) (Rodrigues) and log: SO(3) → R³, |log| in [0, π].
[[nodiscard]] Eigen::Matrix3d so3_exp(const Eigen::Vector3d& rotation_rad);
[[nodiscard]] Eigen::Vector3d so3_log(const Eigen::Matrix3d& rotation);

/// exp: R⁶ → SE(3) and its inverse for rotations below π (Barfoot 2017, sections 7.1.3–7.1.4).
[[nodiscard]] Pose3 se3_exp(const Twist& twist);
[[nodiscard]] Twist se3_log(const Pose3& pose);

/// The pose at share s of the way from `start` (s = 0) to `end` (s = 1) at constant body twist:
/// start · exp(s · log(start⁻¹ end)). s outside [0, 1] extrapolates.
[[nodiscard]] Pose3 interpolate(const Pose3& start, const Pose3& end, double share);

}  // namespace honka
