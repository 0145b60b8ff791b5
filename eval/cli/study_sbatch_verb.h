#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "eval/cli/verbs.h"

namespace honka::eval {

struct SbatchArguments : ScenarioArguments {
  std::optional<std::int64_t> trials;  ///< at each point, in place of the scenario's
  std::int64_t shards = 0;
  std::int64_t threads = 8;  ///< of a member of the array
  std::string time, memory, partition;
  std::vector<std::string> extra;  ///< more options of sbatch
  std::filesystem::path out;       ///< empty: results/<path of the scenario under scenarios/>
};

/// Adds `sbatch` below the verb `study`; typed, it becomes the action.
void add_study_sbatch(CLI::App& study, SbatchArguments& arguments, std::function<int()>& action);

/// Writes the job scripts into the study's folder and says what to type next.
int study_sbatch_verb(const SbatchArguments& arguments);

}  // namespace honka::eval
