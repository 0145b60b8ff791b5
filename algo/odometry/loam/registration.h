#pragma once

#include <Eigen/Core>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/odometry/loam/settings.h"
#include "algo/odometry/odometry.h"

namespace honka {

/// A feature and what it lies on in the map: one or two planes, in units of its noise.
///
/// Residual k is row k of `normals` times (T p − anchor). A line is two planes across each other.
struct LoamMatch {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();   ///< p, in the lidar frame at mid-sweep
  Eigen::Vector3d anchor_m = Eigen::Vector3d::Zero();  ///< in the odom frame
  Eigen::Matrix<double, 2, 3> normals = Eigen::Matrix<double, 2, 3>::Zero();  ///< over sigma, 1/m
  bool edge = false;
};

using MatchJacobian = Eigen::Matrix<double, 2, 6>;

/// Residuals of a match at T_odom_lidar and their derivatives by ξ of T exp(ξ) (translation, then
/// rotation vector). Zhang2014 Eqs. (2) and (3) as vectors.
[[nodiscard]] Eigen::Vector2d match_residual(const LoamMatch& match, const Pose3& T_odom_lidar);
[[nodiscard]] MatchJacobian match_jacobian(const LoamMatch& match, const Pose3& T_odom_lidar);

/// What the features see of the six directions of motion.
struct LoamRegistration {
  Pose3 T_odom_lidar = Pose3::Identity();
  Covariance6 covariance = Covariance6::Identity();
  std::size_t edges_offered = 0, edges_matched = 0, planes_matched = 0;
  std::size_t edges_close = 0;  ///< within three s.d. of their line
  int weak_directions = 0;      ///< that keep the prediction
  bool converged = false;

  [[nodiscard]] double close_share() const {
    return edges_offered == 0
               ? 0.0
               : static_cast<double>(edges_close) / static_cast<double>(edges_offered);
  }
};

/// Moves result.T_odom_lidar along the directions that the matches observe, and fills in its
/// covariance, weak_directions and converged.
///
/// Levenberg–Marquardt (Zhang2014 Eq. (12)) with Cauchy weights and constant velocity as one more
/// measurement. At the start the eigenvalues of JᵀJ, without that measurement, part the directions
/// into observed and weak ones; weak ones keep the value they came with (Zhang2016, section III).
void solve_matches(const std::vector<LoamMatch>& matches, const Pose3& T_odom_predicted,
                   const LoamRegistrationSettings& settings, LoamRegistration& result);

}  // namespace honka
