#include "eval/run/slam/selection_experiment.h"

#include <fmt/format.h>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/scenario_json.h"
#include "eval/run/slam/selection_figures.h"
#include "eval/run/slam/selection_tables.h"

namespace honka::eval {
namespace {

std::vector<SelectionCase> select_pairs(const RunRequest& request) {
  std::vector<SelectionCase> cases;
  const TrialRange trials = trials_of(request);
  for (std::int64_t trial = trials.first; trial < trials.end; ++trial) {
    const ImprovementStart start = improvement_start(request, trial);
    for (SelectionCase& c : run_selection(start, request.resolved.scenario.slam, trial)) {
      cases.push_back(std::move(c));
    }
  }
  return cases;
}

ReportModel selection_report(const RunRequest& request, const std::vector<SelectionCase>& cases,
                             const std::filesystem::path& folder) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.tables = {selection_table(cases)};
  const std::vector<SelectionCase> first = {cases.at(0), cases.at(1)};
  const bool by_icp = scenario.slam.loop.pairs.test == "icp";
  report.figures = {draw_pair_errors(folder / "figures", first),
                    draw_pair_choice(folder / "figures", first[by_icp ? 1 : 0])};
  report.protocol = selection_protocol();
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

}  // namespace

RunOutcome run_selection_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const std::vector<SelectionCase> cases = select_pairs(request);

  Summary summary;
  summary.context = context.entries();
  const Table trials = selection_trial_table(cases), pairs = selection_pair_table(cases);
  summary.results_digest = results_digest({&trials, &pairs});
  write_trials_h5(folder.path() / "trials.h5", summary.context, trials, pairs);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["selection"] = selection_json(cases);
  summary.report = selection_report(request, cases, folder.path());
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(summary.report.tables.front()), request.out, summary.results_digest};
}

}  // namespace honka::eval
