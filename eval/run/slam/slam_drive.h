#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/slam/sparse_frame.h"
#include "algo/types/stem.h"
#include "eval/config/scenario.h"

namespace honka::eval {

/// What the edge made of one drive for the cloud, with the truth of it for the metrics alone.
struct SlamDrive {
  std::vector<SparseFrame> frames;           ///< stems at each key frame, in the lidar's frame
  FramePoses edge_T_first_frame;             ///< the edge's own odometry at each key frame
  FramePoses true_T_first_frame;             ///< truth
  std::vector<double> times_s, travelled_m;  ///< of each key frame
  std::vector<Eigen::Vector3d> true_stems_in_first_m;  ///< at the height where stems are taken
  std::int64_t sweeps = 0;                             ///< of the whole drive
  std::int64_t unregistered_sweeps = 0;                ///< that the odometry could not place
  std::int64_t trees_on_strip = 0;                     ///< of the true stems
  double duration_s = 0.0;                             ///< of the drive
};

/// Drives a trial's strip road with its work cycle, casts every sweep, lets the edge's odometry
/// choose the key frames and Algorithm 1 find their stems. `what` stands before the progress. The
/// digits depend on (scenario, trial) alone, whatever the threads. A drive without a single
/// registered sweep has no frames.
[[nodiscard]] SlamDrive drive_for_slam(const Scenario& scenario, std::int64_t trial, int threads,
                                       const std::string& what);

}  // namespace honka::eval
