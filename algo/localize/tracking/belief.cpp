#include "algo/localize/tracking/belief.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka {
namespace {

Eigen::Matrix3d symmetric_part(const Eigen::Matrix3d& m) { return 0.5 * (m + m.transpose()); }

Eigen::Matrix3d variances(double metres, double radians) {
  return Eigen::Vector3d(metres * metres, metres * metres, radians * radians).asDiagonal();
}

Eigen::Matrix3d random_walk(double way_m, double turn_rad, double duration_s,
                            const OdometryNoiseSettings& noise) {
  return way_m * variances(noise.sigma_m_per_sqrt_m, deg_to_rad(noise.sigma_deg_per_sqrt_m)) +
         turn_rad * variances(0.0, deg_to_rad(noise.sigma_deg_per_sqrt_turn)) +
         duration_s * variances(noise.sigma_m_per_sqrt_s, deg_to_rad(noise.sigma_deg_per_sqrt_s));
}

/// Of a motion that no registration saw.
Eigen::Matrix3d unobserved(double duration_s, const OdometryNoiseSettings& noise) {
  return variances(noise.unobserved_m_per_s * duration_s,
                   deg_to_rad(noise.unobserved_deg_per_s) * duration_s);
}

/// Whether a direction is not known to 0.1 m, a radian counting 10 m: the mark of odometries here.
bool is_unobserved(const Eigen::Matrix3d& covariance) {
  constexpr double kKnown_m = 0.1, kLever_m = 10.0;
  return std::max({covariance(0, 0), covariance(1, 1), kLever_m * kLever_m * covariance(2, 2)}) >
         kKnown_m * kKnown_m;
}

}  // namespace

Eigen::Vector3d pose_difference(const Pose2& a, const Pose2& b) {
  Eigen::Vector3d difference;
  difference << a.translation_m - b.translation_m, wrap_to_pi(a.yaw_rad - b.yaw_rad);
  return difference;
}

OdometryStep odometry_step(const Pose2& T_last_now, double duration_s,
                           const std::optional<Eigen::Matrix3d>& stated,
                           const TrackingSettings& settings) {
  const double way_m = T_last_now.translation_m.norm();
  const double turn_rad = std::abs(T_last_now.yaw_rad);
  if (!stated) return {T_last_now, random_walk(way_m, turn_rad, duration_s, settings.odometry)};
  if (is_unobserved(*stated)) return {T_last_now, unobserved(duration_s, settings.odometry)};
  // One registration error for each view of other stems.
  return {T_last_now, (way_m / settings.shared_length_m + turn_rad) * *stated};
}

OdometryStep carrying_step(const Pose2& T_fix_now, double duration_s,
                           const std::optional<Eigen::Matrix3d>& stated,
                           const TrackingSettings& settings) {
  OdometryStep step = odometry_step(T_fix_now, duration_s, stated, settings);
  if (stated && !is_unobserved(*stated)) step.covariance += *stated;
  return step;
}

Eigen::Matrix3d motion_jacobian(const Pose2& from, const Pose2& to) {
  // δp' = δp + (∂R/∂ψ) u δψ, δψ' = δψ
  const Eigen::Vector2d step = to.translation_m - from.translation_m;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = -step.y();
  F(1, 2) = step.x();
  return F;
}

Eigen::Matrix3d covariance_in_map(const OdometryStep& step, const Pose2& T_map_now) {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(T_map_now.yaw_rad).toRotationMatrix();
  return R * step.covariance * R.transpose();
}

Belief moved(const Belief& belief, const OdometryStep& step) {
  Belief now;
  now.T_map_lidar = belief.T_map_lidar * step.T_last_now;
  const Eigen::Matrix3d F = motion_jacobian(belief.T_map_lidar, now.T_map_lidar);
  now.covariance = symmetric_part(F * belief.covariance * F.transpose() +
                                  covariance_in_map(step, now.T_map_lidar));
  return now;
}

double mahalanobis_squared(const Belief& a, const Belief& b) {
  const Eigen::Vector3d difference = pose_difference(a.T_map_lidar, b.T_map_lidar);
  const Eigen::LDLT<Eigen::Matrix3d> sum(a.covariance + b.covariance);
  const double squared = difference.dot(sum.solve(difference));
  return std::isfinite(squared) && sum.isPositive() ? squared : INFINITY;
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
