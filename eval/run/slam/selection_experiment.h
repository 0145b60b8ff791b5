#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Figures 9 and 10 of Nevalainen et al. 2021: how pairs of frames are found and chosen.
[[nodiscard]] RunOutcome run_selection_experiment(const RunRequest& request);

}  // namespace honka::eval
