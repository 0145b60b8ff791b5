#include "algo/odometry/key_frames.h"

#include "algo/geometry/se3.h"
#include "algo/types/check.h"

namespace honka {

void describe(SettingsVisitor& v, KeyFrameSettings& s) {
  v.field({"distance_m", "m", "least way between two key frames", "Li2020 section 2.6"},
          s.distance_m, {0.001, 1000.0});
  v.field({"angle_deg", "deg", "least turn between two key frames, where the way is shorter",
           "Li2020 section 2.6"},
          s.angle_deg, {0.1, 180.0});
  v.field({"sweeps", "", "revolutions that one key frame holds",
           "choice: one gives the paper's 54 trunks a frame, three give 100"},
          s.sweeps, {1, 100});
  v.field({"min_range_m", "m", "nearer returns are dropped: the machine itself",
           "choice: the crane as it is carried ends 3.2 m ahead of the sensor"},
          s.min_range_m, {0.0, 1000.0});
  v.field({"max_range_m", "m", "farther returns are dropped",
           "choice: channels are 1.4 m apart there; 60 m costs a fifth of the recall"},
          s.max_range_m, {1.0, 1000.0});
}

KeyFrameSelector::KeyFrameSelector(const KeyFrameSettings& settings)
    : distance_m_(settings.distance_m), angle_rad_(deg_to_rad(settings.angle_deg)) {
  HONKA_CHECK(distance_m_ > 0.0 && angle_rad_ > 0.0, "key frames need a positive spacing");
}

bool KeyFrameSelector::is_key_frame(const Pose3& T_odom_lidar) {
  // A drive in steps of exactly the spacing must not lose a key frame to rounding.
  constexpr double kRounding = 1e-9;
  if (T_odom_last_) {
    const Pose3 T_last_lidar = T_odom_last_->inverse() * T_odom_lidar;
    const double way_m = T_last_lidar.translation().norm();
    const double turn_rad = so3_log(T_last_lidar.linear()).norm();
    if (way_m < distance_m_ - kRounding && turn_rad < angle_rad_ - kRounding) return false;
  }
  T_odom_last_ = T_odom_lidar;
  return true;
}

}  // namespace honka
