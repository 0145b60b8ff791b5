#include "algo/odometry/loam/motion.h"

#include <algorithm>

#include "algo/types/angles.h"

namespace honka {

Pose3 LoamMotion::predicted() const {
  return T_odom_last * se3_exp(std::min(periods, kMostCoastedPeriods) * last_twist);
}

Twist LoamMotion::twist_to(const Pose3& T_odom_lidar) const {
  return se3_log(T_odom_last.inverse() * T_odom_lidar) / periods;
}

bool LoamMotion::allows(const Pose3& T_odom_lidar, const LoamMotionSettings& settings,
                        double period_s) const {
  const Pose3 off = predicted().inverse() * T_odom_lidar;
  const double gap_s = std::max(0.0, periods - 1.0) * period_s;
  const double way_m = settings.jump_m + settings.most_speed_m_s * gap_s;
  const double turn_deg = settings.jump_deg + settings.most_turn_deg_s * gap_s;
  return off.translation().norm() <= way_m && so3_log(off.linear()).norm() <= deg_to_rad(turn_deg);
}

}  // namespace honka
