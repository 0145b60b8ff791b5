#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace honka::architecture {

/// Lines that break a rule, each as "file:line: what is wrong".
using Violations = std::vector<std::string>;

/// Which folders a folder's files may include, and where each outside package may be included.
[[nodiscard]] Violations wrong_includes(const std::filesystem::path& root);
/// A `main` anywhere but in eval/cli, tests and benchmarks.
[[nodiscard]] Violations wrong_mains(const std::filesystem::path& root);
/// Words that no committed source holds: machine paths and left-over markers.
[[nodiscard]] Violations wrong_words(const std::filesystem::path& root);
/// Sources of more than 300 lines.
[[nodiscard]] Violations long_files(const std::filesystem::path& root);
/// Entries at the top level that the plan of the house does not name.
[[nodiscard]] Violations strange_top_level(const std::filesystem::path& root);
/// Equations cited in algo that the index in algo/README.md does not list, and rows of the index
/// whose files do not exist.
[[nodiscard]] Violations unindexed_equations(const std::filesystem::path& root);

}  // namespace honka::architecture
