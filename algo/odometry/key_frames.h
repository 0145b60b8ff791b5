#pragma once

#include <cstdint>
#include <optional>

#include "algo/types/pose.h"
#include "algo/types/settings.h"

namespace honka {

/// When a sweep becomes a key frame, and which of its returns are used.
struct KeyFrameSettings {
  double distance_m = 0.3;
  double angle_deg = 30.0;
  std::int64_t sweeps = 1;
  double min_range_m = 3.5;
  double max_range_m = 40.0;
};

void describe(SettingsVisitor& v, KeyFrameSettings& s);

/// Picks the sweeps that lie far enough from the last key frame (Li2020, section 2.6).
class KeyFrameSelector {
 public:
  /// Ends the program on a distance or angle that is not positive.
  explicit KeyFrameSelector(const KeyFrameSettings& settings);

  /// True for the first pose, and for one that is at least `distance_m` away from the last key
  /// frame (Euclidean, in 3D) or turned by at least `angle_deg` (angle of the relative rotation);
  /// that pose is then the last key frame.
  bool is_key_frame(const Pose3& T_odom_lidar);

 private:
  double distance_m_;
  double angle_rad_;
  std::optional<Pose3> T_odom_last_;
};

}  // namespace honka
