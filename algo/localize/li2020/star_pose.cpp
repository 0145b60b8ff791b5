#include "algo/localize/li2020/star_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algo/geometry/fit_pose.h"

namespace honka {
namespace {

using Six = StarVertices<2>;

template <int D>
StarPoint<D> mean_of(const StarVertices<D>& points) {
  StarPoint<D> sum = StarPoint<D>::Zero();
  for (const StarPoint<D>& p : points) sum += p;
  return sum / 6.0;
}

/// Angle that turns a into the direction of b, in [−π, π]; sign(0) = +1, arccos clipped.
double signed_angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double lengths = a.norm() * b.norm();
  if (lengths == 0.0) return 0.0;
  const double sign = a.x() * b.y() - a.y() * b.x() < 0.0 ? -1.0 : 1.0;
  return sign * std::acos(std::clamp(a.dot(b) / lengths, -1.0, 1.0));
}

double cost_of(double angle, const Six& local, const Six& map) {
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(angle).toRotationMatrix();
  double cost = 0.0;
  for (std::size_t j = 0; j < 6; ++j) cost += (R * local[j] - map[j]).norm();
  return cost;
}

}  // namespace

StarPose star_pose(const Six& local_m, const Six& map_m) {
  const Eigen::Vector2d local_mean = mean_of<2>(local_m);
  const Eigen::Vector2d map_mean = mean_of<2>(map_m);
  Six local = local_m;
  Six map = map_m;
  for (Eigen::Vector2d& p : local) p -= local_mean;
  for (Eigen::Vector2d& p : map) p -= map_mean;

  // Li2020 Eq. (3)
  StarPose pose;
  pose.cost_m = INFINITY;
  for (std::size_t i = 0; i < 6; ++i) {
    const double beta = signed_angle(local[i], map[i]);
    const double cost = cost_of(beta, local, map);
    if (cost < pose.cost_m) {
      pose.cost_m = cost;
      pose.theta_rad = beta;
    }
  }
  pose.printed_translation_m = map_mean - local_mean;
  pose.translation_m = map_mean - Eigen::Rotation2Dd(pose.theta_rad) * local_mean;
  return pose;
}

SpaceStarPose star_pose(const StarVertices<3>& local_m, const StarVertices<3>& map_m) {
  SpaceStarPose pose;
  pose.T_map_local = fit_pose(map_m, local_m);
  pose.printed_translation_m = mean_of<3>(map_m) - mean_of<3>(local_m);
  for (std::size_t j = 0; j < 6; ++j) {
    pose.cost_m += (pose.T_map_local * local_m[j] - map_m[j]).norm();
  }
  return pose;
}

}  // namespace honka
