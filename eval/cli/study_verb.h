#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>

#include "eval/cli/study_sbatch_verb.h"
#include "eval/cli/verbs.h"

namespace honka::eval {

struct StudyArguments : ScenarioArguments {
  std::optional<std::int64_t> trials;  ///< at each point, in place of the scenario's
  std::string shard = "0/1";
  int threads = 0;            ///< 0: as many as there are cores
  std::filesystem::path out;  ///< empty: results/<path of the scenario under scenarios/>
};

/// All that `honka study …` can be given.
struct StudyVerbArguments {
  StudyArguments run;
  SbatchArguments sbatch;
  std::filesystem::path folder;  ///< of status, merge and retry-failed
  int retry_threads = 0;
};

/// Adds the verb with its own ones; the one that is typed becomes the action.
void add_study(CLI::App& app, StudyVerbArguments& arguments, std::function<int()>& action);

int study_verb(const StudyArguments& arguments);
int study_status_verb(const std::filesystem::path& folder);
int study_merge_verb(const std::filesystem::path& folder);
int study_retry_verb(const std::filesystem::path& folder, int threads);

/// `honka run` on the scenario of a study: one trial at one point, or the advice to use study.
int study_trial_verb(const RunArguments& arguments);

}  // namespace honka::eval
