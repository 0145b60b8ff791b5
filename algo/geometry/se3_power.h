#pragma once

#include <Eigen/Core>

#include "algo/types/pose.h"

namespace honka {

/// Powers τ^u of one rigid transform: the share u of its screw motion, any real u. Axis, angle and
/// what Eq. 8 needs of the translation are worked out once, so that many u cost little.
///
/// Within 1e-12 of the exact power for angles from 0 to π − 1e-6; at exactly π the axis has two
/// signs and one is taken. No series is used: (1 − cos θu) / tan(θ/2) and sin θu / tan(θ/2) keep
/// their digits for every θ > 0 when the cosine is written as a squared sine.
/// Source: Nevalainen2021 §2.1.
class PosePower {
 public:
  /// `T_a_b` must be finite.
  explicit PosePower(const Pose3& T_a_b);

  /// τ^u: the identity at 0, `T_a_b` at 1, its inverse at −1.
  [[nodiscard]] Pose3 operator()(double u) const;

  [[nodiscard]] const Eigen::Vector3d& axis() const { return axis_; }  ///< unit; z without turn
  [[nodiscard]] double angle_rad() const { return angle_rad_; }        ///< in [0, π]
  [[nodiscard]] const Eigen::Vector3d& translation_m() const { return p_; }

 private:
  Eigen::Vector3d axis_ = Eigen::Vector3d::UnitZ();
  double angle_rad_ = 0.0;
  double tan_half_ = 0.0;
  Eigen::Vector3d p_, axis_cross_p_, axis_cross_twice_p_;
};

/// τ^u for a single u. Nevalainen2021 §2.1.
[[nodiscard]] Pose3 pose_power(const Pose3& T_a_b, double u);

}  // namespace honka
