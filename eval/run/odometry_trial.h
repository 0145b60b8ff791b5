#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/odometry/odometry.h"
#include "eval/config/scenario.h"
#include "eval/metrics/trajectory_pairs.h"
#include "eval/run/odometry_stands.h"

namespace honka::eval {

/// What one odometry made of one drive, sweep by sweep, with the truth of it.
struct OdometryRun {
  std::string stand, odometry;
  std::int64_t trial = 0;
  double period_s = 0.1;                    ///< of a sweep
  std::vector<OdometryEstimate> estimates;  ///< one a sweep, refused ones too
  PosePairs pairs;                          ///< at each sweep's start: T_world_lidar, T_odom_lidar
  std::vector<double> driven_m;             ///< way of the machine at each sweep's start
  std::vector<double> times_ms;             ///< processor time of each sweep
};

/// Names of the odometries that the scenario asks for.
[[nodiscard]] std::vector<std::string> odometries_of(const Scenario& scenario);

/// Drives through a stand once; every odometry takes the same sweeps, each cast once. `what` stands
/// before the progress. The digits depend on (scenario, stand, trial) alone, whatever the threads.
[[nodiscard]] std::vector<OdometryRun> run_odometry_trial(const Scenario& scenario,
                                                          const NamedStand& stand,
                                                          std::int64_t trial, int threads,
                                                          const std::string& what);

}  // namespace honka::eval
