#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Stem lists without rays, found in maps of any size by every matcher side by side.
[[nodiscard]] RunOutcome run_sighting_experiment(const RunRequest& request);

}  // namespace honka::eval
