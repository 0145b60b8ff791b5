#include "eval/run/localize/options_experiment.h"

#include <cmath>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/io/table.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/options_tables.h"
#include "eval/run/progress.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {
namespace {

struct OptionsResults {
  std::vector<OptionsRow> rows;
  std::vector<SelectionComparison> selections;
};

OptionsResults run_options(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  const std::vector<OptionsCase> cases = options_cases(scenario);
  OptionsResults results;
  for (const OptionsCase& one : cases) results.rows.push_back({one, {}, 0});
  Progress progress("options", "cases", (end - first) * static_cast<std::int64_t>(cases.size()));
  for (std::int64_t trial = first; trial < end; ++trial) {
    const OptionsWorld world = make_options_world(scenario, trial);
    for (OptionsRow& row : results.rows) {
      const auto answers = answer_options(scenario, world, row.what, request.threads);
      row.answers.insert(row.answers.end(), answers.begin(), answers.end());
      row.stems_in_map = static_cast<std::int64_t>(
          (row.what.map == "airborne" ? world.airborne_m : world.inventory_m).size());
      progress.advance();
    }
    const auto selections = compare_selections(scenario, world);
    results.selections.insert(results.selections.end(), selections.begin(), selections.end());
  }
  return results;
}

}  // namespace

RunOutcome run_options_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const OptionsResults results = run_options(request);

  Summary summary;
  summary.context = context.entries();
  const Table answers = options_answer_table(results.rows);
  const Table selections = selection_row_table(results.selections);
  summary.results_digest = results_digest({&answers, &selections});
  write_trials_h5(folder.path() / "trials.h5", summary.context, answers, selections);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["options"] = options_json(results.rows, scenario);
  summary.tables["selections"] = selections_json(results.selections);
  ReportModel& report = summary.report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.tables = {options_table(results.rows), selections_table(results.selections)};
  report.protocol = options_protocol(scenario);
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(report.tables[0]) + console_table(report.tables[1]), request.out,
          summary.results_digest};
}

}  // namespace honka::eval
