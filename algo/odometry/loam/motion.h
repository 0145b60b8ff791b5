#pragma once

#include "algo/geometry/se3.h"
#include "algo/odometry/loam/settings.h"

namespace honka {

/// Revolutions for which constant velocity is believed: a second at 10 Hz. Then the machine stands.
inline constexpr double kMostCoastedPeriods = 10.0;

/// From the last sweep to this one: what constant velocity says, and what a machine can do.
struct LoamMotion {
  Pose3 T_odom_last = Pose3::Identity();  ///< at the middle of the last sweep
  Twist last_twist = Twist::Zero();       ///< of the lidar in one revolution
  double periods = 1.0;                   ///< revolutions since then, above 0

  /// Constant velocity, over a gap for at most kMostCoastedPeriods.
  [[nodiscard]] Pose3 predicted() const;
  /// The twist of one revolution that leads to this pose.
  [[nodiscard]] Twist twist_to(const Pose3& T_odom_lidar) const;
  /// Whether the pose is within reach: `jump_m` and `jump_deg` off the prediction, more after a
  /// gap of `period_s` and longer.
  [[nodiscard]] bool allows(const Pose3& T_odom_lidar, const LoamMotionSettings& settings,
                            double period_s) const;
};

}  // namespace honka
