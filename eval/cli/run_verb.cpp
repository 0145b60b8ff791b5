#include <fmt/core.h>

#include "algo/types/user_error.h"
#include "eval/cli/study_verb.h"
#include "eval/cli/verbs.h"
#include "eval/config/located_error.h"
#include "eval/config/scenario.h"
#include "eval/run/experiment.h"
#include "eval/run/simulate.h"
#include "eval/run/thread_count.h"

namespace honka::eval {
namespace {

/// The command that does this again, as a user would type it.
std::string command_line(const RunArguments& arguments) {
  std::string command = "honka run " + arguments.scenario.string();
  for (const std::string& text : arguments.all_overrides()) command += " -s '" + text + "'";
  if (arguments.trial) command += fmt::format(" --trial {}", *arguments.trial);
  return command;
}

/// Does the work; a mistake of the scenario that shows on the way is led back to its line.
template <class Work>
auto with_located_errors(const ResolvedScenario& resolved, Work work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw UserError(located(error.what(), resolved));
  }
}

}  // namespace

int run_verb(const RunArguments& arguments) {
  RunRequest request;
  request.resolved = load_scenario(arguments.scenario, arguments.all_overrides());
  if (request.resolved.scenario.study.asked_for()) return study_trial_verb(arguments);
  request.threads = thread_count(arguments.threads);
  request.trial = arguments.trial;
  request.out = arguments.out.empty() ? "results" / std::filesystem::path(request.resolved.name)
                                      : arguments.out;
  request.command = command_line(arguments);
  const Experiment& experiment = find_experiment(request.resolved);
  const RunOutcome outcome =
      with_located_errors(request.resolved, [&] { return experiment.run(request); });
  fmt::print("{}\nresults_digest {}\nReport: {}\n", outcome.table, outcome.digest,
             (outcome.folder / "report.html").string());
  return 0;
}

int simulate_verb(const SimulateArguments& arguments) {
  const ResolvedScenario resolved = load_scenario(arguments.scenario, arguments.all_overrides());
  const SimulateOutcome outcome = with_located_errors(
      resolved, [&] { return simulate(resolved, arguments.out, thread_count(arguments.threads)); });
  fmt::print(
      "{}: {} sweeps, {} shots, {:.1f} % with a return\n"
      "Judge a trajectory estimated from it: honka score {} POSES.tum\n",
      arguments.out.string(), outcome.sweeps, outcome.shots,
      100.0 * static_cast<double>(outcome.returns) /
          static_cast<double>(std::max<std::int64_t>(1, outcome.shots)),
      arguments.out.string());
  return 0;
}

}  // namespace honka::eval
