#include "algo/localize/tracking/belief.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "algo/types/check.h"

namespace honka {
namespace {

/// (x, y, yaw) from b to a, the yaw wrapped.
Eigen::Vector3d pose_difference(const Pose2& a, const Pose2& b) {
  Eigen::Vector3d difference;
  difference << a.translation_m - b.translation_m, wrap_to_pi(a.yaw_rad - b.yaw_rad);
  return difference;
}

/// Covariance of an increment along the lidar's axes.
Eigen::Vector3d increment_variance(const Pose2& increment, double duration_s,
                                   const OdometryNoiseSettings& noise) {
  const auto squared = [](double value) { return value * value; };
  const double way_m = increment.translation_m.norm();
  const double position =
      squared(noise.sigma_m_per_sqrt_m) * way_m + squared(noise.sigma_m_per_sqrt_s) * duration_s;
  const double yaw =
      squared(deg_to_rad(noise.sigma_deg_per_sqrt_m)) * way_m +
      squared(deg_to_rad(noise.sigma_deg_per_sqrt_turn)) * std::abs(increment.yaw_rad) +
      squared(deg_to_rad(noise.sigma_deg_per_sqrt_s)) * duration_s;
  return {position, position, yaw};
}

Eigen::Matrix3d symmetric_part(const Eigen::Matrix3d& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

Belief moved(const Belief& belief, const Pose2& T_last_now, double duration_s,
             const OdometryNoiseSettings& noise) {
  Belief now;
  now.T_map_lidar = belief.T_map_lidar * T_last_now;
  // δp' = δp + (∂R/∂ψ) u δψ, δψ' = δψ
  const Eigen::Vector2d step = now.T_map_lidar.translation_m - belief.T_map_lidar.translation_m;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = -step.y();
  F(1, 2) = step.x();
  const Eigen::Vector3d variance = increment_variance(T_last_now, duration_s, noise);
  // Equal along both axes of the lidar, so the same in the map's.
  now.covariance = symmetric_part(F * belief.covariance * F.transpose());
  now.covariance.diagonal() += variance;
  return now;
}

double mahalanobis_squared(const Belief& a, const Belief& b) {
  const Eigen::Vector3d difference = pose_difference(a.T_map_lidar, b.T_map_lidar);
  const Eigen::LDLT<Eigen::Matrix3d> sum(a.covariance + b.covariance);
  const double squared = difference.dot(sum.solve(difference));
  return std::isfinite(squared) && sum.isPositive() ? squared : INFINITY;
}

Belief fused(const Belief& belief, const Belief& fix) {
  const Eigen::Matrix3d sum = belief.covariance + fix.covariance;
  const Eigen::Matrix3d gain = sum.ldlt().solve(belief.covariance).transpose();
  const Eigen::Vector3d correction = gain * pose_difference(fix.T_map_lidar, belief.T_map_lidar);
  Belief result;
  result.T_map_lidar.translation_m = belief.T_map_lidar.translation_m + correction.head<2>();
  result.T_map_lidar.yaw_rad = wrap_to_pi(belief.T_map_lidar.yaw_rad + correction.z());
  const Eigen::Matrix3d rest = Eigen::Matrix3d::Identity() - gain;
  result.covariance = symmetric_part(rest * belief.covariance * rest.transpose() +
                                     gain * fix.covariance * gain.transpose());
  return result;
}

double chi_square_3_quantile(double probability) {
  HONKA_CHECK(probability > 0.0 && probability < 1.0, "a probability strictly between 0 and 1");
  const auto below = [](double x) {
    return std::erf(std::sqrt(0.5 * x)) - std::sqrt(2.0 * x / kPi) * std::exp(-0.5 * x);
  };
  double low = 0.0;
  double high = 1.0;
  while (below(high) < probability && high < 1e3) high *= 2.0;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (below(middle) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double largest_position_sigma_m(const Belief& belief) {
  const Eigen::Matrix2d position = belief.covariance.topLeftCorner<2, 2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(axes.eigenvalues().maxCoeff(), 0.0));
}

}  // namespace honka
