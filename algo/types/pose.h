#pragma once

#include <Eigen/Geometry>

#include "algo/types/angles.h"

namespace honka {

/// A rigid transform in 3D; `T_a_b` maps points given in b into a. Metres.
using Pose3 = Eigen::Isometry3d;

/// A rigid transform in the plane, `T_a_b`: x_a = R(yaw) x_b + t. Metres and radians.
struct Pose2 {
  Eigen::Vector2d translation_m = Eigen::Vector2d::Zero();
  double yaw_rad = 0.0;  ///< counter-clockwise from x, in (−π, π]

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& point) const {
    return Eigen::Rotation2Dd(yaw_rad) * point + translation_m;
  }
  [[nodiscard]] Pose2 operator*(const Pose2& other) const {
    return {*this * other.translation_m, wrap_to_pi(yaw_rad + other.yaw_rad)};
  }
  [[nodiscard]] Pose2 inverse() const {
    return {Eigen::Rotation2Dd(-yaw_rad) * Eigen::Vector2d(-translation_m), wrap_to_pi(-yaw_rad)};
  }
};

/// Yaw of the x axis of b seen in a, in (−π, π].
[[nodiscard]] inline double yaw_of(const Pose3& T_a_b) {
  return std::atan2(T_a_b.linear()(1, 0), T_a_b.linear()(0, 0));
}

/// The planar part: x, y and yaw.
[[nodiscard]] inline Pose2 planar(const Pose3& T_a_b) {
  return {T_a_b.translation().head<2>(), yaw_of(T_a_b)};
}

/// From position and roll, pitch, yaw: R = Rz(yaw) Ry(pitch) Rx(roll); x ahead, y left, z up.
[[nodiscard]] inline Pose3 pose_from_rpy(const Eigen::Vector3d& translation_m, double roll_rad,
                                         double pitch_rad, double yaw_rad) {
  Pose3 T_a_b = Pose3::Identity();
  T_a_b.translation() = translation_m;
  T_a_b.linear() = (Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                    Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()))
                       .toRotationMatrix();
  return T_a_b;
}

}  // namespace honka
