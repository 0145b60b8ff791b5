#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Drives that are tracked by every method of variants.methods, with and without the prior of the
/// track: tables, figures and the report.
[[nodiscard]] RunOutcome run_tracking_experiment(const RunRequest& request);

}  // namespace honka::eval
