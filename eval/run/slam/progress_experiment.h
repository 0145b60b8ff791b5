#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// The claims of Nevalainen et al. 2021 about the loop's course, over several rounds, with the
/// update on the right (as printed) and on the left.
[[nodiscard]] RunOutcome run_progress_experiment(const RunRequest& request);

}  // namespace honka::eval
