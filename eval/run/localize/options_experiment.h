#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// The paper's future work, option by option, beside its literal form on the same stem lists.
[[nodiscard]] RunOutcome run_options_experiment(const RunRequest& request);

}  // namespace honka::eval
