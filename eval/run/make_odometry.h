#pragma once

#include <cstdint>
#include <memory>

#include "algo/odometry/odometry.h"
#include "eval/config/experiment_settings.h"
#include "sim/world/trajectory.h"

namespace honka::eval {

/// The odometry that `settings.source` names, at its start: truth+noise over a drive of `sweeps`
/// sweeps, or one of the scans, which looks at neither truth nor seed. Keeps `truth` by reference.
[[nodiscard]] std::unique_ptr<Odometry> make_odometry(const OdometrySettings& settings,
                                                      const sim::Trajectory& truth,
                                                      const LidarModel& model, std::int64_t sweeps,
                                                      std::uint64_t seed);

}  // namespace honka::eval
