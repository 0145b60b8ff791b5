#pragma once

#include <Eigen/Core>

#include "algo/localize/tracking/settings.h"
#include "algo/types/pose.h"

namespace honka {

/// A pose in the plane and what is believed of its error: the error state (x, y, yaw) is additive
/// in the map frame. Metres, radians.
struct Belief {
  Pose2 T_map_lidar;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Moves a belief by an odometry increment (the lidar's new pose seen from its last one) that took
/// `duration_s`. The covariance grows by the lever of the yaw error and by the noise: s² per metre,
/// per radian turned and per second, along the lidar's axes.
[[nodiscard]] Belief moved(const Belief& belief, const Pose2& T_last_now, double duration_s,
                           const OdometryNoiseSettings& noise);

/// Of two beliefs of the same pose with independent errors: dᵀ (P_a + P_b)⁻¹ d, chi-square with
/// three degrees of freedom. Not finite covariances give infinity.
[[nodiscard]] double mahalanobis_squared(const Belief& a, const Belief& b);

/// The Kalman update of a belief by another, independent one of the same pose; Joseph's form.
[[nodiscard]] Belief fused(const Belief& belief, const Belief& fix);

/// The value that a chi-square of three degrees of freedom stays below with this probability.
/// probability: in (0, 1).
[[nodiscard]] double chi_square_3_quantile(double probability);

/// Largest standard deviation of the position over all directions. Metres.
[[nodiscard]] double largest_position_sigma_m(const Belief& belief);

}  // namespace honka
