#include <algorithm>
#include <cmath>

#include "eval/metrics/localization.h"
#include "eval/metrics/statistics.h"
#include "eval/run/localize/tracking_rows.h"

namespace honka::eval {
namespace {

constexpr double kChiSquare3At95 = 7.815;

/// The first event of a kind at or after a time.
std::optional<double> first_event_s(const TrackedRun& run, TrackEvent::Kind kind, double from_s) {
  for (const TrackEvent& event : run.events) {
    if (event.kind == kind && event.time_s >= from_s) return event.time_s;
  }
  return std::nullopt;
}

/// The earlier of two times, of which either may be missing.
std::optional<double> earlier(std::optional<double> a, std::optional<double> b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

bool was_kidnapped(const TrackingDrive& drive) { return drive.kidnapped_s >= 0.0; }

void judge_events(const TrackingDrive& drive, const TrackedRun& run, TrackingRow& row) {
  using Kind = TrackEvent::Kind;
  row.first_pose_s = first_event_s(run, Kind::kInitialised, 0.0);
  for (const TrackEvent& event : run.events) {
    const bool after = was_kidnapped(drive) && event.time_s >= drive.kidnapped_s;
    if (event.kind == Kind::kLost) ++row.losses;
    if (event.kind == Kind::kKidnapped && !after) ++row.false_kidnappings;
  }
  if (!was_kidnapped(drive)) return;
  const auto lost = first_event_s(run, Kind::kLost, drive.kidnapped_s);
  const auto moved = first_event_s(run, Kind::kKidnapped, drive.kidnapped_s);
  const auto seen = earlier(lost, moved);
  if (seen) row.detect_s = *seen - drive.kidnapped_s;
  const auto back = first_event_s(run, Kind::kRecovered, moved.value_or(INFINITY));
  if (back) row.recover_s = *back - drive.kidnapped_s;
}

/// Whether a scan lies between the kidnapping and what the track says of it.
bool is_unnoticed(const TrackingDrive& drive, const TrackingRow& row, double time_s) {
  if (!was_kidnapped(drive) || time_s < drive.kidnapped_s) return false;
  return time_s < drive.kidnapped_s + row.detect_s.value_or(INFINITY);
}

/// The longest time without a localization, and what the track was worth at its end.
void judge_coasting(const TrackingDrive& drive, const TrackedRun& run, TrackingRow& row) {
  for (std::size_t k = 0; k < run.poses.size(); ++k) {
    const TrackedPose& pose = run.poses[k];
    if (pose.state != TrackState::kCoasting || is_unnoticed(drive, row, pose.time_s)) continue;
    if (pose.since_fix_s < row.longest_coast_s.value_or(0.0)) continue;
    row.longest_coast_s = pose.since_fix_s;
    const Pose2& truth = drive.scans[k].T_world_lidar;
    row.coast_error_m = pose_error(pose.belief.T_map_lidar, truth).translation_m;
    row.coast_sigma_m = largest_position_sigma_m(pose.belief);
    row.coast_end_s = first_event_s(run, TrackEvent::Kind::kRecovered, pose.time_s);
  }
}

/// NEES of scans with a pose, by state.
struct NeesOfStates {
  std::vector<double> all, tracking, coasting;

  void add(TrackState state, double nees) {
    all.push_back(nees);
    (state == TrackState::kCoasting ? coasting : tracking).push_back(nees);
  }
  [[nodiscard]] std::optional<double> inside() const {
    if (all.empty()) return std::nullopt;
    const auto below = [](double nees) { return nees < kChiSquare3At95; };
    return static_cast<double>(std::count_if(all.begin(), all.end(), below)) /
           static_cast<double>(all.size());
  }
};

void judge_poses(const TrackingDrive& drive, const TrackedRun& run, double stretch_m,
                 TrackingRow& row) {
  std::vector<double> errors_m;
  NeesOfStates nees;
  std::int64_t with_pose = 0;
  double way_m = 0.0;
  for (std::size_t k = 0; k < run.poses.size(); ++k) {
    const TrackedPose& pose = run.poses[k];
    if (!pose.has_pose()) continue;
    ++with_pose;
    if (is_unnoticed(drive, row, pose.time_s)) continue;
    const TrackedScan& scan = drive.scans[k];
    errors_m.push_back(pose_error(pose.belief.T_map_lidar, scan.T_world_lidar).translation_m);
    nees.add(pose.state, nees_of(pose, scan.T_world_lidar));
    if (k == 0) continue;
    way_m +=
        (scan.T_odom_lidar.translation_m - drive.scans[k - 1].T_odom_lidar.translation_m).norm();
  }
  row.scans = static_cast<std::int64_t>(run.poses.size());
  if (row.scans > 0) {
    row.with_pose_share = static_cast<double>(with_pose) / static_cast<double>(row.scans);
  }
  row.track_rmse_m = rmse(errors_m);
  row.track_max_m = maximum(errors_m);
  row.nees_mean = mean(nees.all);
  row.nees_inside = nees.inside();
  row.nees_tracking = mean(nees.tracking);
  row.nees_coasting = mean(nees.coasting);
  row.stretches = static_cast<std::int64_t>(way_m / stretch_m);
}

/// Error of the odometry that starts at the true pose, up to the kidnapping.
std::optional<double> odometry_rmse_m(const TrackingDrive& drive) {
  if (drive.scans.empty()) return std::nullopt;
  const TrackedScan& start = drive.scans.front();
  const Pose2 T_world_odom = start.T_world_lidar * start.T_odom_lidar.inverse();
  std::vector<double> errors_m;
  for (const TrackedScan& scan : drive.scans) {
    if (was_kidnapped(drive) && scan.time_s >= drive.kidnapped_s) break;
    errors_m.push_back(
        pose_error(T_world_odom * scan.T_odom_lidar, scan.T_world_lidar).translation_m);
  }
  return rmse(errors_m);
}

void judge_localizations(const TrackedRun& run, const SuccessLimits& limits, TrackingRow& row) {
  std::vector<double> right_m, times_ms;
  for (const TrackedLocalization& one : run.localizations) {
    ++row.localizations;
    times_ms.push_back(one.time_ms);
    if (!one.accepted) continue;
    ++row.accepted;
    const bool taken = one.use == FixUse::kUsed || one.use == FixUse::kRestart;
    if (judge(true, {one.error_m, one.error_rad}, limits).right) {
      right_m.push_back(one.error_m);
    } else {
      ++row.wrong_accepted;
      row.wrong_used += taken ? 1 : 0;
    }
  }
  row.fix_rmse_m = rmse(right_m);
  row.time_p50_ms = percentile(times_ms, 50.0).value_or(0.0);
  row.time_p95_ms = percentile(times_ms, 95.0).value_or(0.0);
}

}  // namespace

double nees_of(const TrackedPose& pose, const Pose2& truth) {
  return mahalanobis_squared(pose.belief, {truth, Eigen::Matrix3d::Zero()});
}

TrackingRow judge_track(const TrackingDrive& drive, const TrackedRun& run, const Scenario& scenario,
                        std::int64_t trial) {
  TrackingRow row;
  row.trial = trial;
  row.method = run.what.method;
  row.frames = scenario.tracking.frames[run.what.view];
  row.with_prior = run.what.with_prior;
  judge_events(drive, run, row);
  judge_poses(drive, run, scenario.tracking.filter.shared_length_m, row);
  judge_coasting(drive, run, row);
  judge_localizations(
      run, {scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg}, row);
  row.odometry_rmse_m = odometry_rmse_m(drive);
  return row;
}

}  // namespace honka::eval
