#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen2021 Figs. 2 and 3: frames between two frames, and what is lost in taking a power and
/// then its inverse, over 300 random transforms.
[[nodiscard]] RunOutcome run_power_experiment(const RunRequest& request);

}  // namespace honka::eval
