#include "eval/run/localize/tracking_case.h"

#include "eval/metrics/localization.h"
#include "eval/run/stopwatch.h"

namespace honka::eval {
namespace {

TrackedLocalization localize_view(const TrackingDrive& drive, const TrackedView& view,
                                  const Matcher& matcher, const TrackingCase& what,
                                  PoseTracker& tracker) {
  TrackedLocalization done;
  done.scan = view.scan;
  const auto prior = what.with_prior ? tracker.prior() : std::nullopt;
  done.by_prior = prior.has_value();
  const Stopwatch watch;
  const LocateResult answer = matcher.locate(view.stems_in_local_m[what.view], prior);
  done.time_ms = watch.milliseconds();
  done.accepted = answer.accepted();
  done.T_map_local = answer.T_map_local;
  const TrackedScan& scan = drive.scans[view.scan];
  const PoseError error = pose_error(answer.T_map_local, scan.T_world_lidar);
  done.error_m = error.translation_m;
  done.error_rad = error.rotation_rad;
  if (done.accepted) {
    done.use =
        tracker.add_fix({scan.time_s, scan.T_odom_lidar, answer.T_map_local, answer.covariance});
  } else {
    tracker.add_miss();
  }
  return done;
}

}  // namespace

TrackedRun track_drive(const TrackingDrive& drive, const TrackingCase& what,
                       const Scenario& scenario) {
  TrackedRun run{what, {}, {}, {}};
  const auto matcher = create_matcher(what.method, drive.map_m, scenario.localize);
  PoseTracker tracker(scenario.tracking.filter);
  auto view = drive.views.begin();
  for (std::size_t k = 0; k < drive.scans.size(); ++k) {
    const TrackedScan& scan = drive.scans[k];
    (void)tracker.add_odometry(scan.time_s, scan.T_odom_lidar, scan.covariance);
    for (; view != drive.views.end() && view->scan < k; ++view) {
      run.localizations.push_back(localize_view(drive, *view, *matcher, what, tracker));
    }
    run.poses.push_back(tracker.pose());
  }
  run.events = tracker.events();
  return run;
}

}  // namespace honka::eval
