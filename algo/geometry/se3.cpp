#include "algo/geometry/se3.h"

#include <cmath>

namespace honka {
namespace {

Eigen::Matrix3d skew(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

constexpr double kSmallAngle = 1e-4;  // the next term of each series is then below 1e-17

/// V with t = V ρ: I + (1 − cos φ)/φ² [φ] + (φ − sin φ)/φ³ [φ]².
Eigen::Matrix3d left_jacobian(const Eigen::Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const Eigen::Matrix3d cross = skew(rotation_rad);
  const double a2 = angle * angle;
  const bool small = angle < kSmallAngle;
  const double b = small ? 0.5 - a2 / 24.0 : 2.0 * std::pow(std::sin(0.5 * angle), 2) / a2;
  const double c = small ? 1.0 / 6.0 - a2 / 120.0 : (angle - std::sin(angle)) / (a2 * angle);
  return Eigen::Matrix3d::Identity() + b * cross + c * cross * cross;
}

}  // namespace

Eigen::Matrix3d so3_exp(const Eigen::Vector3d& rotation_rad) {
  const double angle = rotation_rad.norm();
  const Eigen::Matrix3d cross = skew(rotation_rad);
  const double a2 = angle * angle;
  const bool small = angle < kSmallAngle;
  const double a = small ? 1.0 - a2 / 6.0 : std::sin(angle) / angle;
  const double b = small ? 0.5 - a2 / 24.0 : 2.0 * std::pow(std::sin(0.5 * angle), 2) / a2;
  return Eigen::Matrix3d::Identity() + a * cross + b * cross * cross;
}

Eigen::Vector3d so3_log(const Eigen::Matrix3d& rotation) {
  // Through the unit quaternion, which keeps its digits near 0 and near π.
  Eigen::Quaterniond q(rotation);
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return 2.0 * std::atan2(sine, q.w()) / sine * q.vec();
}

Pose3 se3_exp(const Twist& twist) {
  Pose3 pose = Pose3::Identity();
  pose.linear() = so3_exp(twist.tail<3>());
  pose.translation() = left_jacobian(twist.tail<3>()) * twist.head<3>();
  return pose;
}

Twist se3_log(const Pose3& pose) {
  Twist twist;
  twist.tail<3>() = so3_log(pose.linear());
  twist.head<3>() = left_jacobian(twist.tail<3>()).inverse() * pose.translation();
  return twist;
}

Pose3 interpolate(const Pose3& start, const Pose3& end, double share) {
  return start * se3_exp(share * se3_log(start.inverse() * end));
}

}  // namespace honka
