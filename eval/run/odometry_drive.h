#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "algo/odometry/odometry.h"
#include "algo/odometry/track.h"
#include "eval/run/progress.h"
#include "sim/harvester/vehicle.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/world/recording.h"

namespace honka::eval {

/// A sweep of a drive and what the odometry made of it.
struct DriveSweep {
  sim::TruthfulSweep sweep;
  OdometryEstimate estimate;
};

/// Whole sweeps that a drive holds.
[[nodiscard]] std::int64_t sweeps_of(const sim::Vehicle& vehicle, const LidarModel& model);

/// One sweep of a drive with its truth. The machine's own parts stand as they do in its middle.
[[nodiscard]] sim::TruthfulSweep cast_sweep(const sim::Vehicle& vehicle,
                                            const sim::LidarSimulator& lidar, std::int64_t index);

/// The sweep's index and times alone: what an odometry takes that needs no returns.
[[nodiscard]] Sweep empty_sweep(const LidarModel& model, std::int64_t index);

using TakeSweep = std::function<void(sim::TruthfulSweep&&)>;

/// Casts the sweeps of these indices in parallel and hands them to `take` one at a time, in the
/// order of the list, while the next are being cast. At most one sweep a thread is in memory. What
/// `take` throws comes out when all threads have come to rest.
void stream_sweeps(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar,
                   const std::vector<std::int64_t>& indices, int threads, Progress& progress,
                   const TakeSweep& take);

/// The same with every sweep of the drive.
void stream_sweeps(const sim::Vehicle& vehicle, const sim::LidarSimulator& lidar, int threads,
                   Progress& progress, const TakeSweep& take);

/// Streams every sweep of a drive to an odometry, then to `sink` (which may be empty). The digits
/// do not depend on the threads. Where the odometry needs no returns none are cast: the sweeps that
/// `sink` gets then hold index and times alone, and stream_sweeps casts those that are wanted.
[[nodiscard]] OdometryTrack drive_with_odometry(const sim::Vehicle& vehicle,
                                                const sim::LidarSimulator& lidar,
                                                Odometry& odometry, int threads, Progress& progress,
                                                const std::function<void(DriveSweep&&)>& sink);

}  // namespace honka::eval
