#include "eval/run/localize/localize_results.h"

#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {

RunOutcome write_localize_results(const RunRequest& request, const Context& context,
                                  OutputFolder& folder, LocalizeResults results) {
  const Scenario& scenario = request.resolved.scenario;
  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&results.trials, &results.frames});
  write_trials_h5(folder.path() / "trials.h5", summary.context, results.trials, results.frames);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables = std::move(results.tables);
  summary.metrics = std::move(results.metrics);
  ReportModel& report = summary.report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.lead_notes = std::move(results.notes);
  report.tables = std::move(results.report_tables);
  report.figures = std::move(results.figures);
  report.protocol = std::move(results.protocol);
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(report.tables.front()), request.out, summary.results_digest};
}

std::string table_name_of(const ResolvedScenario& resolved) {
  return resolved.name.substr(resolved.name.find_last_of('/') + 1);
}

}  // namespace honka::eval
