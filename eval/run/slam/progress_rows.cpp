#include "eval/run/slam/progress_tables.h"

namespace honka::eval {

Table progress_trial_table(const std::vector<ProgressTrack>& tracks) {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  const std::vector<std::string> texts;
  Table table({
      {"trial", "", "trial (seed)", integers},
      {"side", "", "of the update", texts},
      {"key_frames", "", "of the drive", integers},
      {"corrections", "", "applied over all rounds", integers},
      {"blur_floor", "", "at true poses", numbers},
      {"cluster_rmse_floor_m", "m", "at true poses, mean over clusters, link 0.5 m", numbers},
      {"dimension_floor", "", "at true poses, box counting over 0.2 to 3.2 m", numbers},
      {"step_error_floor_m", "m", "at true poses, mean over the chain", numbers},
  });
  for (const ProgressTrack& track : tracks) {
    table.add_row(track.trial, track.side, track.frames, track.points.back().applied,
                  track.floor.blur, track.floor.cluster_rmse_m, track.floor.dimension,
                  track.floor.step_error_m);
  }
  return table;
}

Table progress_point_table(const std::vector<ProgressTrack>& tracks) {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  Table table({
      {"trial", "", "row in /trials", integers},
      {"round", "", "1 for the first; 0 at the start", integers},
      {"tried", "", "pairs so far", integers},
      {"corrections", "", "applied so far", integers},
      {"go_icp_calls", "", "so far", integers},
      {"blur", "", "of the map", numbers},
      {"cluster_rmse_m", "m", "mean over clusters, link 0.5 m; where it was measured", numbers},
      {"dimension", "", "box counting over 0.2 to 3.2 m", numbers},
      {"two_scale_dimension", "", "of 0.2 and 10 m", numbers},
      {"step_error_m", "m", "mean over the chain", numbers},
      {"ate_m", "m", "RMSE of positions after rigid alignment", numbers},
  });
  for (std::size_t row = 0; row < tracks.size(); ++row) {
    for (const ProgressPoint& point : tracks[row].points) {
      const MapFigures& map = point.map;
      table.add_row(row, point.round, point.tried, point.applied, point.go_icp_calls, map.blur,
                    map.cluster_rmse_m, map.dimension, map.two_scale_dimension, map.step_error_m,
                    map.ate_m);
    }
  }
  return table;
}

}  // namespace honka::eval
