#pragma once

#include <string>

#include "eval/config/scenario.h"

namespace honka::eval {

/// The message of a mistake that shows only while the world is built ("forest.spacing.strauss: the
/// stems do not fit at this density; lower forest.density_per_ha …"), led by the place where the
/// scenario sets the first key it names; by the file where it sets none of them. Messages that name
/// no key stay as they are.
[[nodiscard]] std::string located(const std::string& message, const ResolvedScenario& resolved);

}  // namespace honka::eval
