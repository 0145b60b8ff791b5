#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Real field maps against one terrestrial scan each: the pairs, and every wrong combination.
[[nodiscard]] RunOutcome run_stem_pairs_experiment(const RunRequest& request);

}  // namespace honka::eval
