#pragma once

#include <nlohmann/json_fwd.hpp>

#include "eval/metrics/trajectory_errors.h"

namespace honka::eval {

/// `translation_m` and `rotation_deg`, each {rmse, mean, median, std, min, max, sse} at full
/// precision, or null where there are no errors of the kind.
[[nodiscard]] nlohmann::ordered_json errors_json(const TrajectoryErrors& errors);

}  // namespace honka::eval
