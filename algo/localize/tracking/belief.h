#pragma once

#include <Eigen/Core>
#include <optional>

#include "algo/localize/tracking/settings.h"
#include "algo/types/pose.h"

namespace honka {

/// A pose in the plane and what is believed of its error: the error state (x, y, yaw) is additive
/// in the map frame. Metres, radians.
struct Belief {
  Pose2 T_map_lidar;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// (x, y, yaw) from b to a, the yaw wrapped.
[[nodiscard]] Eigen::Vector3d pose_difference(const Pose2& a, const Pose2& b);

/// The lidar's new pose seen from its last one, and the covariance of the new pose's (x, y, yaw)
/// along its own axes.
struct OdometryStep {
  Pose2 T_last_now;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The step between two poses of the odometry that took `duration_s`. `stated`: covariance of the
/// registration that gave the new pose, as OdometryEstimate::covariance has it for (x, y, yaw);
/// without one, the random walk of `settings.odometry`.
[[nodiscard]] OdometryStep odometry_step(const Pose2& T_last_now, double duration_s,
                                         const std::optional<Eigen::Matrix3d>& stated,
                                         const TrackingSettings& settings);

/// The step that carries a fix from its frame to the last scan: with all of the registration's
/// error, which lies between where the frame was and where the odometry has it.
[[nodiscard]] OdometryStep carrying_step(const Pose2& T_fix_now, double duration_s,
                                         const std::optional<Eigen::Matrix3d>& stated,
                                         const TrackingSettings& settings);

/// How an error (x, y, yaw) in the map passes on from a pose to one that odometry leads to.
[[nodiscard]] Eigen::Matrix3d motion_jacobian(const Pose2& from, const Pose2& to);

/// A step's covariance along the axes of the map.
[[nodiscard]] Eigen::Matrix3d covariance_in_map(const OdometryStep& step, const Pose2& T_map_now);

/// Moves a belief: its covariance grows by the lever of the yaw error and by the step's.
[[nodiscard]] Belief moved(const Belief& belief, const OdometryStep& step);

/// Of two beliefs of the same pose with independent errors: dᵀ (P_a + P_b)⁻¹ d, chi-square with
/// three degrees of freedom. Not finite covariances give infinity.
[[nodiscard]] double mahalanobis_squared(const Belief& a, const Belief& b);

/// The value that a chi-square of three degrees of freedom stays below with this probability.
/// probability: in (0, 1).
[[nodiscard]] double chi_square_3_quantile(double probability);

/// Largest standard deviation of the position over all directions. Metres.
[[nodiscard]] double largest_position_sigma_m(const Belief& belief);

}  // namespace honka
