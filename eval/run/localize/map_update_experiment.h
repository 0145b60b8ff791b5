#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Drives through thinned stands, localized in the old map, in that map as the drive itself updates
/// it, and in a new one.
[[nodiscard]] RunOutcome run_map_update_experiment(const RunRequest& request);

}  // namespace honka::eval
