#include "eval/run/localize/tracking_experiment.h"

#include <optional>

#include "algo/types/user_error.h"
#include "eval/config/words.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/tracking_figures.h"
#include "eval/run/localize/tracking_rows.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {
namespace {

std::vector<TrackingCase> tracking_cases(const Scenario& scenario) {
  std::vector<std::string> methods = words_of(scenario.variants.methods);
  if (methods.empty()) methods = {scenario.localize.method};
  if (scenario.tracking.frames.empty()) {
    throw UserError("tracking.study.frames is empty; give at least one number, [1]");
  }
  std::vector<TrackingCase> cases;
  for (const std::string& method : methods) {
    for (std::size_t view = 0; view < scenario.tracking.frames.size(); ++view) {
      cases.push_back({method, view, false});
      cases.push_back({method, view, true});
    }
  }
  return cases;
}

struct TrackingResults {
  std::vector<TrackingRow> rows;
  std::vector<ReportFigure> figures;  ///< of the last track without prior of the first trial
};

TrackingResults track_trials(const RunRequest& request, const std::filesystem::path& figures) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  TrackingResults results;
  for (std::int64_t trial = first; trial < end; ++trial) {
    const TrackingDrive drive = make_tracking_drive(scenario, trial, request.threads);
    std::optional<TrackedRun> shown;
    for (const TrackingCase& what : tracking_cases(scenario)) {
      TrackedRun run = track_drive(drive, what, scenario);
      results.rows.push_back(judge_track(drive, run, scenario, trial));
      if (!what.with_prior) shown = std::move(run);
    }
    if (trial == first && shown) results.figures = draw_tracking(figures, drive, *shown);
  }
  return results;
}

ReportModel tracking_report(const RunRequest& request, const TrackingResults& results) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.tables = tracking_tables(results.rows);
  report.figures = results.figures;
  report.protocol = tracking_protocol(scenario);
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

}  // namespace

RunOutcome run_tracking_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const TrackingResults results = track_trials(request, folder.path() / "figures");

  Summary summary;
  summary.context = context.entries();
  const Table trials = tracking_trial_table(results.rows);
  summary.results_digest = results_digest({&trials});
  write_trials_h5(folder.path() / "trials.h5", summary.context, trials, Table{});
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["tracking"] = tracking_json(results.rows, scenario);
  summary.report = tracking_report(request, results);
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  const auto& tables = summary.report.tables;
  return {console_table(tables[0]) + console_table(tables[1]), request.out, summary.results_digest};
}

}  // namespace honka::eval
