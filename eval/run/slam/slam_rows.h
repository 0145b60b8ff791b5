#pragma once

#include "eval/io/table.h"
#include "eval/run/slam/slam_trial.h"

namespace honka::eval {

/// One row a trial and case: /trials of trials.h5.
[[nodiscard]] Table slam_run_table();
/// One row a trial, case and key frame, with the poses: /frames.
[[nodiscard]] Table slam_frame_table();

/// Appends a trial to both. A drive without frames is one row that says so.
void append_slam_trial(const SlamTrial& trial, Table& runs, Table& frames);

}  // namespace honka::eval
