#pragma once

#include <filesystem>

#include "eval/study/study.h"
#include "tests/eval/io/temporary_folder.h"

namespace honka::test {

/// A study of two points and two methods whose trials are arithmetic, but for those that a law
/// wants to go wrong: trial 3 of point 1 throws, 4 ends its process, 5 never ends, 6 takes memory
/// without end. `harmless` has none of these.
[[nodiscard]] eval::Study fake_study(const TemporaryFolder& folder, std::int64_t trials,
                                     bool harmless = true, const std::string& more = "");

}  // namespace honka::test
