#include "eval/run/run_tracks.h"

#include <fmt/format.h>

namespace honka::eval {

RunTrack track_of_run(std::string run, const Drive& drive) {
  RunTrack track;
  track.run = std::move(run);
  for (const OdometryEstimate& estimate : drive.track.estimates()) {
    const double time_s = estimate.start_time_s;
    track.estimate.push_back({time_s, estimate.T_odom_start});
    track.truth.push_back({time_s, drive.vehicle->trajectory().T_world_lidar(time_s)});
  }
  return track;
}

void write_run_tracks(const std::filesystem::path& folder, std::int64_t trial,
                      const std::vector<RunTrack>& tracks) {
  for (const RunTrack& track : tracks) {
    const std::string name = fmt::format("stand_{}_{}", trial, track.run);
    write_tum(folder / (name + ".tum"), track.estimate);
    write_tum(folder / (name + "_truth.tum"), track.truth);
  }
}

}  // namespace honka::eval
