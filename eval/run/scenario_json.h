#pragma once

#include "eval/config/scenario.h"
#include "eval/report/summary.h"

namespace honka::eval {

/// Every key of the resolved scenario with its value, in the order of description.
[[nodiscard]] Json resolved_keys(const Scenario& scenario);

}  // namespace honka::eval
