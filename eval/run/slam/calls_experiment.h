#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen et al. 2021, Table 2: how often the loop calls ICP and Go-ICP, and what a call takes;
/// beside them, other ways to register the same pairs from the same guesses.
[[nodiscard]] RunOutcome run_calls_experiment(const RunRequest& request);

}  // namespace honka::eval
