#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "eval/config/scenario.h"

namespace honka::eval {

/// What `honka run` was asked for.
struct RunRequest {
  ResolvedScenario resolved;
  int threads = 1;
  std::optional<std::int64_t> trial;  ///< this one alone
  std::filesystem::path out;          ///< folder of the results
  std::string command;                ///< as typed, for the report
};

/// Trials [first, end).
struct TrialRange {
  std::int64_t first = 0, end = 0;
};

/// All trials of the scenario, or the one of --trial. UserError where there is no such trial.
[[nodiscard]] TrialRange trials_of(const RunRequest& request);

/// What a run tells its user at the end.
struct RunOutcome {
  std::string table;  ///< "paper | ours", for the terminal
  std::filesystem::path folder;
  std::string digest;
};

using RunExperiment = RunOutcome (*)(const RunRequest& request);

/// A kind of experiment that `experiment = "…"` in a scenario can name.
struct Experiment {
  std::string name, help;
  RunExperiment run;
};

/// Every experiment; a new one is one file and one line here.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// The experiment that a scenario names. UserError with the known names when there is none.
[[nodiscard]] const Experiment& find_experiment(const ResolvedScenario& resolved);

}  // namespace honka::eval
