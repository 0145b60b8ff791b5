#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen2021 Fig. 1: what one frame sees, and how far natural neighbours are from each other
/// at each range, over all key frames of a drive.
[[nodiscard]] RunOutcome run_view_experiment(const RunRequest& request);

}  // namespace honka::eval
