#include "eval/metrics/localization.h"

#include <Eigen/LU>
#include <cmath>

#include "algo/types/angles.h"

namespace honka::eval {

PoseError pose_error(const Pose2& T_map_estimate, const Pose2& T_map_truth) {
  return {(T_map_estimate.translation_m - T_map_truth.translation_m).norm(),
          std::abs(wrap_to_pi(T_map_estimate.yaw_rad - T_map_truth.yaw_rad))};
}

Outcome judge(bool accepted, const PoseError& error, const SuccessLimits& limits) {
  return {accepted, error.translation_m <= limits.translation_m &&
                        error.rotation_rad <= deg_to_rad(limits.rotation_deg)};
}

std::optional<PoseBound> cramer_rao_bound(std::span<const Eigen::Vector2d> stems_in_local_m,
                                          double sigma_m) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& q : stems_in_local_m) {
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << 1.0, 0.0, -q.y(), 0.0, 1.0, q.x();
    information += jacobian.transpose() * jacobian;
    mean += q / static_cast<double>(stems_in_local_m.size());
  }
  double spread_m2 = 0.0;  // the heading comes from the stems' spread about their mean
  for (const Eigen::Vector2d& q : stems_in_local_m) spread_m2 += (q - mean).squaredNorm();
  if (stems_in_local_m.size() < 2 || spread_m2 < 1e-12) return std::nullopt;
  PoseBound bound;
  bound.covariance = sigma_m * sigma_m * information.inverse();
  bound.translation_m = std::sqrt(bound.covariance(0, 0) + bound.covariance(1, 1));
  bound.rotation_rad = std::sqrt(bound.covariance(2, 2));
  return bound;
}

std::optional<double> simple_bound_m(double sigma_m, std::int64_t stems) {
  if (stems <= 0) return std::nullopt;
  return sigma_m * std::sqrt(2.0 / static_cast<double>(stems));
}

}  // namespace honka::eval
