#pragma once

#include <optional>
#include <string>

#include "algo/localize/matcher.h"

namespace honka::eval {

/// "x,y,radius" in metres of the map frame; UserError with the form for anything else.
[[nodiscard]] LocatePrior parse_prior(const std::string& text);

}  // namespace honka::eval
