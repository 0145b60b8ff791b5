#include "eval/run/slam/slam_experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <iterator>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/io/tum.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/scenario_json.h"
#include "eval/run/slam/slam_figures.h"
#include "eval/run/slam/slam_rows.h"
#include "eval/run/slam/slam_tables.h"

namespace honka::eval {
namespace {

struct SlamResults {
  Table runs = slam_run_table();
  Table frames = slam_frame_table();
  std::vector<SlamTrial> trials;
  std::vector<SlamSummaryRow> rows;
  std::vector<ReportFigure> figures;
};

/// Drives every trial; the last drive is worked on beside the casting of the next.
std::vector<SlamTrial> drive_and_improve(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const auto policy = request.threads > 1 ? std::launch::async : std::launch::deferred;
  std::vector<SlamTrial> trials;
  std::future<SlamTrial> last;
  const TrialRange range = trials_of(request);
  for (std::int64_t trial = range.first; trial < range.end; ++trial) {
    SlamDrive drive = drive_for_slam(scenario, trial, request.threads,
                                     fmt::format("trial {} of {}", trial, scenario.trials));
    if (last.valid()) trials.push_back(last.get());
    last = std::async(policy, [&scenario, trial, &request, driven = std::move(drive)]() mutable {
      return run_slam_trial(std::move(driven), scenario, trial, request.threads);
    });
  }
  trials.push_back(last.get());
  return trials;
}

/// tracks/trial_N_START_TREATMENT.tum and the truth, for `honka evaluate`.
void write_slam_tracks(const std::filesystem::path& folder, const SlamTrial& trial) {
  const auto write = [&](const std::string& name, const FramePoses& poses) {
    std::vector<TimedPose> rows;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      rows.push_back({trial.drive.times_s[i], poses[i]});
    }
    const std::string file = fmt::format("trial_{}_{}.tum", trial.trial, name);
    if (!rows.empty()) write_tum(folder / "tracks" / file, rows);
  };
  write("truth", trial.drive.true_T_first_frame);
  write("edge", trial.drive.edge_T_first_frame);
  for (const SlamRun& run : trial.runs) write(run.start + "_" + run.treatment, run.T_first_frame);
}

SlamResults make_slam_results(const RunRequest& request, const std::filesystem::path& folder) {
  SlamResults results;
  results.trials = drive_and_improve(request);
  for (const SlamTrial& trial : results.trials) {
    append_slam_trial(trial, results.runs, results.frames);
    write_slam_tracks(folder, trial);
  }
  results.rows = summarize_slam(results.trials, slam_cases(request.resolved.scenario));
  const auto& trials = results.trials;
  const auto shown = std::find_if(trials.begin(), trials.end(),
                                  [](const SlamTrial& trial) { return !trial.runs.empty(); });
  if (shown == trials.end()) return results;
  const auto figures = folder / "figures";
  results.figures = {draw_slam_fig11(figures, *shown), draw_slam_blur(figures, results.rows),
                     draw_slam_paths(figures, *shown)};
  return results;
}

bool compares_methods(const Scenario& scenario) { return scenario.slam_study.study == "methods"; }

ReportModel slam_report(const RunRequest& request, const SlamResults& results) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.lead_notes = {
      "The floor is what the same points leave at the true poses: no method can do better on the "
      "path, and one far below it has moved points, not poses.",
      fmt::format("Key frames are {} m or {}° apart by the edge's own odometry ({}); each holds "
                  "the stems that Algorithm 1 finds in {} sweeps.",
                  scenario.slam.keyframe.distance_m, scenario.slam.keyframe.angle_deg,
                  scenario.odometry.source, scenario.frame.sweeps)};
  if (compares_methods(scenario)) {
    report.tables = {slam_methods_table(results.rows)};
  } else {
    report.tables = {slam_table1(results.rows), slam_orders_table(results.trials)};
  }
  report.tables.push_back(slam_drives_table(results.trials));
  report.tables.push_back(slam_details_table(results.rows));
  report.figures = results.figures;
  report.protocol = slam_protocol(scenario);
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

std::map<std::string, Metric> slam_metrics(const std::vector<SlamSummaryRow>& rows) {
  std::map<std::string, Metric> metrics;
  for (const SlamSummaryRow& row : rows) {
    const auto put = [&](const std::string& name, const std::string& unit, const SeedFigure& figure,
                         const SeedFigure* floor) {
      Metric metric;
      metric.value = figure.mean_or_nan();
      metric.unit = unit;
      metric.n = static_cast<std::int64_t>(figure.values.size());
      metric.of = row.trials;
      if (const auto interval = figure.interval())
        metric.interval = {interval->low, interval->high};
      if (floor != nullptr) metric.floor = floor->mean_or_nan();
      metrics[fmt::format("{}_{}_{}", name, row.start, row.treatment)] = metric;
    };
    put("blur", "", row.blur, &row.blur_floor);
    put("cluster_rmse", "m", row.cluster_rmse_m, &row.cluster_rmse_floor_m);
    put("ate", "m", row.ate_m, nullptr);
  }
  return metrics;
}

}  // namespace

RunOutcome run_slam_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const SlamResults results = make_slam_results(request, folder.path());

  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&results.runs, &results.frames});
  write_trials_h5(folder.path() / "trials.h5", summary.context, results.runs, results.frames);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  if (compares_methods(scenario)) {
    summary.tables["methods"] = slam_methods_json(results.rows, scenario);
  } else {
    summary.tables["table1"] = slam_table1_json(results.rows, scenario);
  }
  summary.metrics = slam_metrics(results.rows);
  summary.report = slam_report(request, results);
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(summary.report.tables.front()), request.out, summary.results_digest};
}

}  // namespace honka::eval
