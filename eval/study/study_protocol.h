#pragma once

#include <string>
#include <vector>

#include "eval/study/study.h"

namespace honka::eval {

/// How the figures of a study are made: formula, unit and denominator, a sentence or two each.
[[nodiscard]] std::vector<std::string> study_protocol(const Study& study);

}  // namespace honka::eval
