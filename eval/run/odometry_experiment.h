#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Drives every stand of the scenario (keys stands.*) with every odometry: drift, real-time factor,
/// failures with cause; the tracks as TUM.
[[nodiscard]] RunOutcome run_odometry_experiment(const RunRequest& request);

}  // namespace honka::eval
