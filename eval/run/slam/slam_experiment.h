#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen et al. 2021 on drives of the simulator: the paper's loop from three starts in three
/// orders (Table 1), or methods side by side, or Figure 11, as slam.study says. The next seed is
/// driven while the last one is worked on.
[[nodiscard]] RunOutcome run_slam_experiment(const RunRequest& request);

}  // namespace honka::eval
