#pragma once

#include <string>
#include <vector>

#include "eval/config/scenario.h"

namespace honka::test {

/// A scenario of an experiment that studies repeat, so small that a trial takes milliseconds to
/// tenths of a second; `overrides` ("key=value") on top. REQUIREs that the experiment is known.
[[nodiscard]] eval::Scenario small_study(const std::string& experiment,
                                         const std::vector<std::string>& overrides = {});

}  // namespace honka::test
