#pragma once

#include <optional>
#include <vector>

#include "eval/io/table.h"
#include "eval/report/report_model.h"
#include "eval/report/summary.h"
#include "eval/run/localize/tracking_case.h"

namespace honka::eval {

/// Figures of one tracked drive. A time or error that there is none of is nothing.
struct TrackingRow {
  std::int64_t trial = 0;
  std::string method;
  std::int64_t frames = 1;
  bool with_prior = false;
  std::int64_t scans = 0;
  std::int64_t localizations = 0, accepted = 0, wrong_accepted = 0, wrong_used = 0;
  double with_pose_share = 0.0;        ///< scans with a pose
  std::optional<double> track_rmse_m;  ///< with a pose, and not between kidnapping and its report
  std::optional<double> track_max_m, fix_rmse_m;
  std::optional<double> odometry_rmse_m;  ///< alone, from the true pose of its start, to the hop
  std::optional<double> nees_mean;        ///< of (x, y, yaw); 3 when the covariance is honest
  std::optional<double> nees_inside;      ///< share below the 95 % quantile, 7.81
  std::optional<double> nees_tracking, nees_coasting;  ///< the mean, by state
  std::int64_t stretches = 0;  ///< of tracking.shared_length_m that the NEES was taken over
  std::optional<double> first_pose_s, detect_s, recover_s;
  std::optional<double> longest_coast_s, coast_error_m;  ///< the error at its end
  std::optional<double> coast_sigma_m;  ///< and the largest s.d. that the track states there
  std::optional<double> coast_end_s;    ///< time of the localization that ended it
  std::int64_t false_kidnappings = 0, losses = 0;
  double time_p50_ms = 0.0, time_p95_ms = 0.0;
};

[[nodiscard]] TrackingRow judge_track(const TrackingDrive& drive, const TrackedRun& run,
                                      const Scenario& scenario, std::int64_t trial);

/// Normalized error squared of a pose's (x, y, yaw).
[[nodiscard]] double nees_of(const TrackedPose& pose, const Pose2& truth);

/// Of /trials, /frames (scans of the first run, every tenth) and the tables.
[[nodiscard]] Table tracking_trial_table(const std::vector<TrackingRow>& rows);
[[nodiscard]] SummaryTable tracking_json(const std::vector<TrackingRow>& rows,
                                         const Scenario& scenario);
[[nodiscard]] std::vector<ReportTable> tracking_tables(const std::vector<TrackingRow>& rows);
[[nodiscard]] std::vector<std::string> tracking_protocol(const Scenario& scenario);

}  // namespace honka::eval
