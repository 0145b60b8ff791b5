#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen et al. 2021, Table 3: branch and bound down to leaves of general size and of the size
/// that L0 allows, on the same pairs: sizes by the paper's formulas, nodes and time as measured.
[[nodiscard]] RunOutcome run_granularity_experiment(const RunRequest& request);

}  // namespace honka::eval
