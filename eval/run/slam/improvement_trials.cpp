#include "eval/run/slam/improvement_trials.h"

#include <fmt/format.h>

#include "algo/slam/chain.h"
#include "algo/types/random.h"

namespace honka::eval {

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
