#pragma once

#include <string>
#include <vector>

#include "eval/config/scenario.h"

namespace honka::eval {

/// Every key of a scenario with its value but those that begin with one of `without`, and the
/// measured stem map: equal where two scenarios differ in nothing else.
[[nodiscard]] std::string keys_text(const Scenario& scenario,
                                    const std::vector<std::string>& without);

}  // namespace honka::eval
