#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "eval/io/tum.h"
#include "eval/run/drive.h"

namespace honka::eval {

/// What a lidar odometry made of a run, beside the truth, at each sweep's start.
struct RunTrack {
  std::string run;                  ///< "prior" or "work"
  std::vector<TimedPose> estimate;  ///< T_odom_lidar
  std::vector<TimedPose> truth;     ///< T_world_lidar
};

[[nodiscard]] RunTrack track_of_run(std::string run, const Drive& drive);

/// stand_<trial>_<run>.tum and stand_<trial>_<run>_truth.tum, for `honka evaluate`.
void write_run_tracks(const std::filesystem::path& folder, std::int64_t trial,
                      const std::vector<RunTrack>& tracks);

}  // namespace honka::eval
