#include "eval/run/odometry_rows.h"

#include <limits>

#include "algo/types/pose.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double rmse_or_unknown(const std::vector<double>& errors) {
  return rmse(errors).value_or(kUnknown);
}

}  // namespace

Table odometry_trial_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  const std::vector<std::string> texts;
  return Table({
      {"trial", "", "trial (seed)", integers},
      {"stand", "", "stand", texts},
      {"odometry", "", "odometry", texts},
      {"driven_m", "m", "way of the machine", numbers},
      {"sensor_s", "s", "duration of the drive", numbers},
      {"drift_percent", "%", "mean error of sub-paths over their length", numbers},
      {"drift_deg_per_m", "deg/m", "mean rotation error of sub-paths over their length", numbers},
      {"sub_paths", "", "sub-paths of 10, 20, 50 and 100 m", integers},
      {"rpe_translation_m", "m", "RMSE of the motion over 1 m of path", numbers},
      {"rpe_rotation_deg", "deg", "RMSE of the motion over 1 m of path", numbers},
      {"ape_translation_m", "m", "RMSE after yaw + translation", numbers},
      {"ape_rotation_deg", "deg", "RMSE after yaw + translation", numbers},
      {"registered", "", "sweeps with every direction observed", integers},
      {"degenerate", "", "sweeps registered in part", integers},
      {"predicted", "", "sweeps not registered", integers},
      {"refused", "", "sweeps without a place in time", integers},
      {"lost", "", "lost sequences", integers},
      {"cpu_s", "s", "processor time of the odometry", numbers, false},
  });
}

void append_odometry_trial(Table& table, std::int64_t trial, const OdometryScores& s) {
  const Drift drift = mean_drift(s.sub_paths).value_or(Drift{kUnknown, kUnknown, 0});
  table.add_row(trial, s.stand, s.odometry, s.driven_m, s.sensor_s, drift.percent, drift.deg_per_m,
                drift.sub_paths, rmse_or_unknown(s.rpe_per_metre.translation_m),
                rmse_or_unknown(s.rpe_per_metre.rotation_deg), rmse_or_unknown(s.ape.translation_m),
                rmse_or_unknown(s.ape.rotation_deg), s.statuses[0], s.statuses[1], s.statuses[2],
                s.statuses[3], s.lost.size(), s.cpu_s);
}

Table odometry_sweep_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  return Table({
      {"trial", "", "row of /trials", integers},
      {"sweep", "", "number of the sweep", integers},
      {"time_s", "s", "start of the sweep", numbers},
      {"driven_m", "m", "way of the machine until then", numbers},
      {"x_m", "m", "place of the lidar", numbers, true, "odom"},
      {"y_m", "m", "place of the lidar", numbers, true, "odom"},
      {"z_m", "m", "place of the lidar", numbers, true, "odom"},
      {"yaw_rad", "rad", "heading of the lidar", numbers, true, "odom"},
      {"status", "", "0 registered, 1 degenerate, 2 predicted, 3 refused", integers},
      {"cause", "", "0 none, then as OdometryCause counts", integers},
      {"time_ms", "ms", "processor time", numbers, false},
  });
}

void append_odometry_sweeps(Table& table, std::int64_t row, const OdometryRun& run) {
  for (std::size_t i = 0; i < run.estimates.size(); ++i) {
    const OdometryEstimate& e = run.estimates[i];
    const Eigen::Vector3d place = e.T_odom_start.translation();
    table.add_row(row, e.sweep, run.pairs.poses[i].time_s, run.driven_m[i], place.x(), place.y(),
                  place.z(), yaw_of(e.T_odom_start), static_cast<int>(e.status),
                  static_cast<int>(e.cause), run.times_ms[i]);
  }
}

}  // namespace honka::eval
