#pragma once

#include "eval/run/experiment.h"

namespace honka::eval {

/// Nevalainen2021 Fig. 6: what a simple ICP makes of starts off by (δ, θ), and Eq. 26's quarter
/// ellipse with 4.53° and with the printed 3.7°.
[[nodiscard]] RunOutcome run_convergence_experiment(const RunRequest& request);

/// Nevalainen2021 Fig. 7: the same over the tilt φ of the start, with the paper's limit of 8.2°.
[[nodiscard]] RunOutcome run_tilt_experiment(const RunRequest& request);

}  // namespace honka::eval
