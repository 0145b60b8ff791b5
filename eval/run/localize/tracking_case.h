#pragma once

#include <string>
#include <vector>

#include "algo/localize/tracking/tracker.h"
#include "eval/run/localize/tracking_drive.h"

namespace honka::eval {

/// One way of tracking a drive.
struct TrackingCase {
  std::string method;       ///< matcher
  std::size_t view = 0;     ///< index into tracking.study.frames
  bool with_prior = false;  ///< each localization looks near the track alone, while there is one
};

/// One localization on the way.
struct TrackedLocalization {
  std::size_t scan = 0;
  bool accepted = false, by_prior = false;
  FixUse use = FixUse::kRefused;  ///< of accepted ones
  Pose2 T_map_local;
  double error_m = 0.0, error_rad = 0.0;  ///< to truth
  double time_ms = 0.0;                   ///< of matching alone
};

/// What a tracker made of a drive.
struct TrackedRun {
  TrackingCase what;
  std::vector<TrackedPose> poses;  ///< one a scan
  std::vector<TrackedLocalization> localizations;
  std::vector<TrackEvent> events;
};

/// Tracks a drive: every scan's odometry, and every view's localization one scan later, when its
/// sweep is complete.
[[nodiscard]] TrackedRun track_drive(const TrackingDrive& drive, const TrackingCase& what,
                                     const Scenario& scenario);

}  // namespace honka::eval
