#include "eval/run/localization_experiment.h"

#include <fmt/format.h>

#include "algo/types/user_error.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/localization_figures.h"
#include "eval/run/localization_tables.h"
#include "eval/run/localization_trial.h"
#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/matcher_comparison.h"
#include "eval/run/scenario_json.h"
#include "eval/run/trial_row.h"

namespace honka::eval {
namespace {

struct Results {
  Table trials = trial_table();
  Table frames = localization_table();
  std::vector<ReportFigure> figures;
};

/// Every asked trial, one after the other; the threads work within each.
Results run_trials(const RunRequest& request, const std::filesystem::path& folder) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  Results results;
  for (std::int64_t trial = first; trial < end; ++trial) {
    LocalizationTrial done =
        run_localization_trial(scenario, trial, request.threads, trial == first);
    results.trials.append_rows(done.trials);
    results.frames.append_rows(done.frames);
    write_run_tracks(folder, trial, done.tracks);
    if (done.exhibit) results.figures = draw_exhibit(folder / "figures", *done.exhibit, scenario);
  }
  if (results.frames.rows() == 0) {
    throw UserError(fmt::format(
        "protocol.path_length_m: the drive holds no window of {} key frames; lengthen it",
        scenario.protocol.frames.back()));
  }
  return results;
}

std::vector<std::string> lead_notes(const Scenario& scenario) {
  const OdometrySettings& o = scenario.odometry;
  if (o.source != "truth+noise") {
    return {
        fmt::format(
            "Odometry is {}: every pose comes from the scans. Key frames, windows and maps rest "
            "on it alone.",
            o.source),
        "For the metrics the odometry's frame is laid onto the world by the yaw and the "
        "translation that bring its key frames nearest to the truth; truth enters nowhere "
        "else."};
  }
  return {
      fmt::format(
          "Odometry is {}: poses of key frames are the truth with a drift of {} m and {}° (s.d., "
          "correlated over {} m) and a jitter of {} m and {}° (s.d., independent at each key "
          "frame). Aggregation and mapping rest on this noise, not on an odometry of the scans.",
          o.source, o.drift_m, o.drift_deg, o.correlation_length_m, o.jitter_m, o.jitter_deg),
      "The algorithms see scans and odometry alone; truth enters the metrics only."};
}

ReportModel make_report(const RunRequest& request, const Results& results,
                        const std::vector<LocalizationSummary>& summaries,
                        const std::vector<DetectionSummary>& detection) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.lead_notes = lead_notes(scenario);
  report.tables = {paper_table(summaries, "default", "Table 1 of Li et al. 2020", scenario)};
  if (scenario.variants.same_run && scenario.map.source != "same_run") {
    report.tables.push_back(paper_table(
        summaries, "same_run", "Table 1 with the paper's protocol: map of the same run", scenario));
  }
  if (!scenario.variants.methods.empty()) {
    report.tables.insert(report.tables.begin(), matcher_comparison_table(summaries, scenario));
  }
  report.tables.push_back(world_table(results.trials));
  report.tables.push_back(odometry_table(results.trials));
  report.tables.push_back(variants_table(summaries));
  report.tables.push_back(detection_table(detection, scenario));
  report.tables.push_back(time_table(summaries));
  report.figures = results.figures;
  report.protocol = localization_protocol(scenario);
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

}  // namespace

RunOutcome run_localization_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  static_cast<void>(trials_of(request));  // before anything is written
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const auto figures = folder.path() / "figures";

  // Raw results
  Results results = run_trials(request, folder.path());
  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&results.trials, &results.frames});
  write_trials_h5(folder.path() / "trials.h5", summary.context, results.trials, results.frames);

  // Metrics, figures, report
  const auto summaries = summarize(results.frames, scenario);
  const auto detection = summarize_detection(results.frames);
  for (ReportFigure& figure : draw_statistics(figures, results.frames, summaries, detection)) {
    results.figures.push_back(std::move(figure));
  }
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["table1"] = localization_json(summaries, scenario);
  if (!scenario.variants.methods.empty()) {
    summary.tables[table_name_of(request.resolved)] = matcher_comparison_json(summaries, scenario);
  }
  for (const LocalizationSummary& s : summaries) {
    summary.metrics[fmt::format("success_{}_c{}", s.variant, s.frames)] =
        rate_metric(s.successes, s.windows, s.success_interval);
  }
  summary.report = make_report(request, results, summaries, detection);
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  rebuild_report_beside(request.out);
  return {console_table(summary.report.tables.front()), request.out, summary.results_digest};
}

}  // namespace honka::eval
