#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen2021 Fig. 8: the overlap λ of two view cones, and how well so many samples know it.
[[nodiscard]] RunOutcome run_overlap_experiment(const RunRequest& request);

}  // namespace honka::eval
