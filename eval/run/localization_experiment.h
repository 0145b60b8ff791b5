#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Table 1 of Li et al. 2020: every trial of the scenario, tables, figures and the report.
[[nodiscard]] RunOutcome run_localization_experiment(const RunRequest& request);

}  // namespace honka::eval
