#include "algo/localize/li2020/covariance.h"

#include <Eigen/Cholesky>

namespace honka {
namespace {

/// Variance of a pair's residual on each axis. Pairs that stand in several matches count in each,
/// above and below alike.
double pair_variance(const std::vector<PoseCandidate>& agreeing, const Pose2& T_map_local) {
  double squares = 0.0;
  double equations = -3.0;  // as many go to the pose
  for (const PoseCandidate& candidate : agreeing) {
    for (std::size_t j = 0; j < 6; ++j) {
      squares += (T_map_local * candidate.local_m[j] - candidate.map_m[j]).squaredNorm();
      equations += 2.0;
    }
  }
  return squares / equations;
}

}  // namespace

std::optional<Eigen::Matrix3d> pose_covariance(const std::vector<PoseCandidate>& agreeing,
                                               const PoseCandidate& chosen,
                                               const Pose2& T_map_local,
                                               const Eigen::Vector2d& sensor_m) {
  // dr/d(sensor, yaw): a point moves with the sensor and turns about it.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector2d& point_m : chosen.local_m) {
    const Eigen::Vector2d arm = Eigen::Rotation2Dd(T_map_local.yaw_rad) * (point_m - sensor_m);
    Eigen::Matrix<double, 2, 3> J;
    J << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
    information += J.transpose() * J;
  }
  const Eigen::LLT<Eigen::Matrix3d> root(information);
  constexpr double kOnePoint = 1e-12;  // rounding of stems that lie on one another
  const bool solvable = root.info() == Eigen::Success && root.rcond() > kOnePoint;
  const double variance = pair_variance(agreeing, T_map_local);
  if (!solvable || !(variance > 0.0)) return std::nullopt;
  const Eigen::Matrix3d covariance = variance * root.solve(Eigen::Matrix3d::Identity());
  return 0.5 * (covariance + covariance.transpose());
}

}  // namespace honka
