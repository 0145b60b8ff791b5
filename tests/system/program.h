#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/eval/io/temporary_folder.h"

namespace honka::test {

using Json = nlohmann::ordered_json;

/// What a finished program left.
struct Outcome {
  int exit_code = -1;  ///< 128 + signal where one ended it
  std::string out, err;

  /// Lines of the error stream that do not tell of progress.
  [[nodiscard]] std::vector<std::string> complaints() const;
};

/// Runs the built honka and waits for it. `folder` is the folder that it works in; `meanwhile` is
/// called with its process number as soon as it runs.
[[nodiscard]] Outcome run_honka(const std::vector<std::string>& arguments,
                                const std::filesystem::path& folder,
                                const std::function<void(int child)>& meanwhile = {});

/// Fails the test unless honka ended with exit code 2 and exactly one line of complaint that holds
/// every part.
void check_refused(const Outcome& outcome, const std::vector<std::string>& parts);

/// A scenario that runs in a second or two: 60 m × 60 m of bare stems, a drive of 20 m.
[[nodiscard]] std::string tiny_scenario();

/// The tiny scenario with more text at its end, as `name` in a folder.
void write_tiny(const TemporaryFolder& folder, const std::string& name = "tiny.toml",
                const std::string& more = "");

/// Every file below a folder with its content, by relative path.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> contents(
    const std::filesystem::path& folder);

[[nodiscard]] std::string read_text(const std::filesystem::path& file);
[[nodiscard]] Json read_json(const std::filesystem::path& file);

/// Names of the keys of an object, in order.
[[nodiscard]] std::vector<std::string> keys(const Json& object);

/// A folder beside the project's, which not every machine has.
[[nodiscard]] std::filesystem::path shared(const std::string& path);

}  // namespace honka::test
