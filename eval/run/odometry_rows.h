#pragma once

#include "eval/io/table.h"
#include "eval/run/odometry_scores.h"

namespace honka::eval {

/// The empty table of /trials: one row a trial, stand and odometry.
[[nodiscard]] Table odometry_trial_table();
void append_odometry_trial(Table& table, std::int64_t trial, const OdometryScores& scores);

/// The empty table of /frames: one row a sweep and odometry.
[[nodiscard]] Table odometry_sweep_table();
/// Appends the sweeps of the run whose row in /trials is `row`.
void append_odometry_sweeps(Table& table, std::int64_t row, const OdometryRun& run);

}  // namespace honka::eval
