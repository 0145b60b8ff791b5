#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "algo/odometry/aggregate.h"
#include "eval/config/scenario.h"
#include "eval/run/trial_world.h"
#include "sim/harvester/vehicle.h"
#include "sim/world/recording.h"

namespace honka::eval {

/// A sweep of a key frame with the odometry's poses at its start and end.
struct FrameSweep {
  std::int64_t index = 0;
  Pose3 T_odom_start = Pose3::Identity();
  Pose3 T_odom_end = Pose3::Identity();
};

/// A place that the odometry found worth keeping, with the truth of it for the metrics.
struct KeyFrame {
  std::vector<FrameSweep> sweeps;
  double time_s = 0.0;                      ///< start of the first sweep
  double travelled_m = 0.0;                 ///< along the path
  Pose3 T_odom_lidar = Pose3::Identity();   ///< at time_s
  Pose3 T_world_lidar = Pose3::Identity();  ///< truth at time_s
};

/// A vehicle's drive and its key frames.
struct Drive {
  std::unique_ptr<sim::Vehicle> vehicle;
  std::vector<KeyFrame> key_frames;
};

/// Drives a path and picks the key frames by its odometry. `name` tells the random streams of two
/// drives apart.
[[nodiscard]] Drive make_drive(const std::string& name, const sim::Polyline& path,
                               const sim::VehicleSettings& vehicle, const Scenario& scenario,
                               const TrialWorld& world);

/// Casts the sweeps of a key frame, with their truth.
[[nodiscard]] std::vector<sim::TruthfulSweep> cast_key_frame(const sim::LidarSimulator& lidar,
                                                             const Drive& drive,
                                                             std::size_t key_frame);

/// The sweeps of a key frame with their poses; points into `sweeps`.
[[nodiscard]] std::vector<PosedSweep> posed(const KeyFrame& key_frame,
                                            const std::vector<Sweep>& sweeps);

/// The scans alone, without their truth.
[[nodiscard]] std::vector<Sweep> scans_of(std::vector<sim::TruthfulSweep> sweeps);

}  // namespace honka::eval
