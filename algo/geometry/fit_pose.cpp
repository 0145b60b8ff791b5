#include "algo/geometry/fit_pose.h"

#include <Eigen/SVD>

#include "algo/types/check.h"

namespace honka {

Pose3 fit_pose(std::span<const Eigen::Vector3d> target_m, std::span<const Eigen::Vector3d> source_m,
               const Eigen::Matrix3d& rotation_if_free) {
  HONKA_CHECK(!source_m.empty() && source_m.size() == target_m.size(), "a fit needs pairs");
  Eigen::Vector3d target_mean = Eigen::Vector3d::Zero(), source_mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : target_m) target_mean += p;
  for (const Eigen::Vector3d& p : source_m) source_mean += p;
  target_mean /= static_cast<double>(target_m.size());
  source_mean /= static_cast<double>(source_m.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < source_m.size(); ++k) {
    covariance += (target_m[k] - target_mean) * (source_m[k] - source_mean).transpose();
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& singular = svd.singularValues();
  Pose3 pose = Pose3::Identity();
  pose.linear() = rotation_if_free;
  if (singular[1] > 1e-12 * singular[0]) {
    const Eigen::Matrix3d& U = svd.matrixU();
    const Eigen::Matrix3d& V = svd.matrixV();
    const double sign = (U * V.transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    pose.linear() = U * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * V.transpose();
  }
  pose.translation() = target_mean - pose.linear() * source_mean;
  return pose;
}

}  // namespace honka
