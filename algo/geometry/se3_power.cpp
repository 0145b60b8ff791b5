#include "algo/geometry/se3_power.h"

#include <cmath>

namespace honka {

PosePower::PosePower(const Pose3& T_a_b) : p_(T_a_b.translation()) {
  // Axis and angle through the unit quaternion, which keeps its digits near 0 and near π.
  Eigen::Quaterniond q(T_a_b.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().stableNorm();
  if (sine > 0.0) {
    axis_ = q.vec() / sine;
    angle_rad_ = 2.0 * std::atan2(sine, q.w());
    tan_half_ = sine / q.w();  // infinite at π, where A and B are then 0, as they should be
  }
  axis_cross_p_ = axis_.cross(p_);
  axis_cross_twice_p_ = axis_.cross(axis_cross_p_);
}

Pose3 PosePower::operator()(double u) const {
  const double sine = std::sin(angle_rad_ * u);
  const double half_sine = std::sin(0.5 * angle_rad_ * u);
  const double versine_half = half_sine * half_sine;  // (1 − cos θu) / 2, without cancellation

  // Nevalainen2021 Eq. (6), Nevalainen2021 Eq. (7): rotation by θu about the same axis.
  Pose3 power = Pose3::Identity();
  const double c = 2.0 * versine_half;
  const Eigen::Vector3d& w = axis_;
  const Eigen::Vector3d s = sine * w;
  Eigen::Matrix3d rotation = c * w * w.transpose();
  rotation.diagonal().array() += 1.0 - c;
  rotation(0, 1) -= s.z();
  rotation(0, 2) += s.y();
  rotation(1, 0) += s.z();
  rotation(1, 2) -= s.x();
  rotation(2, 0) -= s.y();
  rotation(2, 1) += s.x();
  power.linear() = rotation;

  // Nevalainen2021 Eq. (15): without a turn the way is straight.
  if (tan_half_ == 0.0) {
    power.translation() = u * p_;
    return power;
  }
  // Nevalainen2021 Eq. (8), Nevalainen2021 Eq. (11), Nevalainen2021 Eq. (12).
  const double a = versine_half / tan_half_;
  const double b = sine / (2.0 * tan_half_);
  power.translation() =
      u * p_ + (a - 0.5 * sine) * axis_cross_p_ + (u - versine_half - b) * axis_cross_twice_p_;
  return power;
}

Pose3 pose_power(const Pose3& T_a_b, double u) { return PosePower(T_a_b)(u); }

}  // namespace honka
