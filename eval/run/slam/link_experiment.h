#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// The bandwidth study: each drive is cast once, its key frames go to the cloud over many links
/// (keys link.*), and the maps that the methods make of what arrived are judged.
[[nodiscard]] RunOutcome run_link_experiment(const RunRequest& request);

}  // namespace honka::eval
