#include "eval/run/slam/improvement_trials.h"

#include <fmt/format.h>

#include "algo/slam/chain.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

namespace honka::eval {

ImprovementTrials improvement_trials(const RunRequest& request) {
  const std::int64_t trials = request.resolved.scenario.trials;
  const std::int64_t first = request.trial.value_or(0);
  if (first >= trials) {
    throw UserError(fmt::format("--trial {}: {} has the trials 0 to {}", first,
                                request.resolved.file.string(), trials - 1));
  }
  return {first, request.trial ? first + 1 : trials};
}

ImprovementStart improvement_start(const RunRequest& request, std::int64_t trial) {
  const Scenario& scenario = request.resolved.scenario;
  ImprovementStart start;
  start.drive =
      drive_for_slam(scenario, trial, request.threads, fmt::format("trial {}, drive", trial));
  start.T_first_frame = make_chain(start.drive.frames, scenario.slam.chain).T_first_frame;
  start.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "improvement",
                           {static_cast<std::uint64_t>(trial)});
  return start;
}

}  // namespace honka::eval
