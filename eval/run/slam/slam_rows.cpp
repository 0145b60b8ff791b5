#include "eval/run/slam/slam_rows.h"

#include <limits>

namespace honka::eval {
namespace {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

double share_of(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : kNoFigure;
}

void append_run(Table& table, const SlamTrial& trial, const SlamRun& run) {
  const SlamDrive& drive = trial.drive;
  const SlamQuality &q = run.quality, &floor = trial.floor;
  table.add_row(trial.trial, drive.frames.empty() ? "no_key_frames" : "done", run.start,
                run.treatment, drive.sweeps, drive.unregistered_sweeps, drive.frames.size(),
                share_of(trial.stems.found, trial.stems.frames),
                share_of(trial.stems.found_matched, trial.stems.found),
                share_of(trial.stems.truth_matched, trial.stems.truth), q.blur, floor.blur,
                q.cluster_rmse_m, floor.cluster_rmse_m, q.cluster_rmse_05_m,
                floor.cluster_rmse_05_m, q.pooled_rmse_m, floor.pooled_rmse_m, q.pooled_rmse_05_m,
                floor.pooled_rmse_05_m, q.box_dimension, floor.box_dimension, q.ate_m,
                q.ate_planar_m, q.ate_deg, run.corrections, run.candidates, run.icp_calls,
                run.go_icp_calls, run.time_s, run.icp_s, run.go_icp_s);
}

void append_key_frames(Table& table, std::int64_t row, const SlamTrial& trial, const SlamRun& run) {
  for (std::size_t i = 0; i < run.T_first_frame.size(); ++i) {
    const Pose3& pose = run.T_first_frame[i];
    const Eigen::Vector3d place = pose.translation();
    table.add_row(row, trial.drive.frames[i].number, trial.drive.times_s[i],
                  trial.drive.travelled_m[i], trial.drive.frames[i].points_m.size(), place.x(),
                  place.y(), place.z(), yaw_of(pose));
  }
}

}  // namespace

Table slam_run_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  const std::vector<std::string> texts;
  return Table({
      {"trial", "", "trial (seed)", integers},
      {"status", "", "done, or no_key_frames: the odometry placed no sweep", texts},
      {"start", "", "poses that were improved", texts},
      {"treatment", "", "none, an order of the paper's loop, or a method", texts},
      {"sweeps", "", "of the drive", integers},
      {"unregistered_sweeps", "", "that the edge's odometry could not place", integers},
      {"key_frames", "", "that the edge sent", integers},
      {"stems_per_frame", "", "mean", numbers},
      {"stem_precision", "", "stems of frames with a true stem within the gate", numbers},
      {"stem_recall", "", "true stems in the view cones that frames hold", numbers},
      {"blur", "", "Nevalainen2021 Eq. 30", numbers},
      {"blur_floor", "", "at true poses", numbers},
      {"cluster_rmse_m", "m", "mean over clusters, link 1.0 m", numbers},
      {"cluster_rmse_floor_m", "m", "at true poses", numbers},
      {"cluster_rmse_05_m", "m", "mean over clusters, link 0.5 m", numbers},
      {"cluster_rmse_05_floor_m", "m", "at true poses", numbers},
      {"pooled_rmse_m", "m", "over all clustered points, link 1.0 m", numbers},
      {"pooled_rmse_floor_m", "m", "at true poses", numbers},
      {"pooled_rmse_05_m", "m", "over all clustered points, link 0.5 m", numbers},
      {"pooled_rmse_05_floor_m", "m", "at true poses", numbers},
      {"box_dimension", "", "slope over 0.2 to 3.2 m", numbers},
      {"box_dimension_floor", "", "at true poses", numbers},
      {"ate_m", "m", "RMSE of positions after a rigid alignment", numbers},
      {"ate_planar_m", "m", "its x and y alone, in the first true frame", numbers},
      {"ate_deg", "deg", "RMSE of rotations after a rigid alignment", numbers},
      {"corrections", "", "corrective matches that were put in", integers},
      {"candidates", "", "pairs that they were chosen from", integers},
      {"icp_calls", "", "for corrective matches", integers},
      {"go_icp_calls", "", "for corrective matches", integers},
      {"time_s", "s", "of the treatment; of none: of the start", numbers, false},
      {"icp_s", "s", "in ICP of corrective matches", numbers, false},
      {"go_icp_s", "s", "in Go-ICP", numbers, false},
  });
}

Table slam_frame_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  return Table({
      {"trial", "", "row of /trials", integers},
      {"frame", "", "number of the key frame", integers},
      {"time_s", "s", "start of its first sweep", numbers},
      {"driven_m", "m", "way of the machine until then", numbers},
      {"stems", "", "in the frame", integers},
      {"x_m", "m", "place of the lidar", numbers, true, "first"},
      {"y_m", "m", "place of the lidar", numbers, true, "first"},
      {"z_m", "m", "place of the lidar", numbers, true, "first"},
      {"yaw_rad", "rad", "heading of the lidar", numbers, true, "first"},
  });
}

void append_slam_trial(const SlamTrial& trial, Table& runs, Table& frames) {
  for (const SlamRun& run : trial.runs) {
    append_key_frames(frames, static_cast<std::int64_t>(runs.rows()), trial, run);
    append_run(runs, trial, run);
  }
  if (trial.runs.empty()) append_run(runs, trial, {});
}

}  // namespace honka::eval
