#include "eval/run/odometry_experiment.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "algo/types/user_error.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/io/tum.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/odometry_figures.h"
#include "eval/run/odometry_rows.h"
#include "eval/run/odometry_tables.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {
namespace {

struct OdometryResults {
  Table trials = odometry_trial_table();
  Table sweeps = odometry_sweep_table();
  std::vector<OdometryScores> scores;  ///< one a stand and odometry
  std::vector<ReportFigure> figures;
};

std::vector<NamedStand> asked_stands(const RunRequest& request) {
  auto stands = stands_of(request.resolved.scenario);
  if (stands.empty()) {
    throw UserError("stands: none is to be driven; set stands.default.run = true");
  }
  return stands;
}

/// STAND_ODOMETRY.tum and STAND_truth.tum; later trials carry their number.
void write_tracks(const std::filesystem::path& folder, const std::vector<OdometryRun>& runs,
                  bool is_first_trial) {
  for (const OdometryRun& run : runs) {
    const std::string suffix = is_first_trial ? "" : fmt::format("_trial{}", run.trial);
    std::vector<TimedPose> truth, estimate;
    for (const PosePair& pair : run.pairs.poses) {
      truth.push_back({pair.time_s, pair.truth});
      estimate.push_back({pair.time_s, pair.estimate});
    }
    write_tum(folder / fmt::format("{}_{}{}.tum", run.stand, run.odometry, suffix), estimate);
    if (&run != &runs.front()) continue;
    write_tum(folder / fmt::format("{}_truth{}.tum", run.stand, suffix), truth);
  }
}

void collect_run(OdometryResults& results, const OdometryRun& run) {
  const OdometryScores scores = score_odometry(run);
  append_odometry_sweeps(results.sweeps, static_cast<std::int64_t>(results.trials.rows()), run);
  append_odometry_trial(results.trials, run.trial, scores);
  const auto known = std::find_if(results.scores.begin(), results.scores.end(), [&](const auto& s) {
    return s.stand == scores.stand && s.odometry == scores.odometry;
  });
  if (known == results.scores.end()) {
    results.scores.push_back(scores);
  } else {
    known->merge(scores);
  }
}

OdometryResults drive_stands(const RunRequest& request, TrialRange trials,
                             const std::vector<NamedStand>& stands,
                             const std::filesystem::path& folder) {
  OdometryResults results;
  for (std::int64_t trial = trials.first; trial < trials.end; ++trial) {
    for (std::size_t i = 0; i < stands.size(); ++i) {
      const std::string what =
          fmt::format("trial {}, stand {} ({} of {})", trial, stands[i].name, i + 1, stands.size());
      const auto runs =
          run_odometry_trial(request.resolved.scenario, stands[i], trial, request.threads, what);
      for (const OdometryRun& run : runs) collect_run(results, run);
      write_tracks(folder, runs, trial == trials.first);
      if (trial != trials.first) continue;
      results.figures.push_back(draw_odometry_tracks(folder / "figures", runs));
      results.figures.push_back(draw_odometry_errors(folder / "figures", runs));
    }
  }
  for (ReportFigure& figure : draw_odometry_drift(folder / "figures", results.scores)) {
    results.figures.push_back(std::move(figure));
  }
  return results;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

ReportModel odometry_report(const RunRequest& request, const OdometryResults& results) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  for (const NamedStand& stand : stands_of(scenario)) {
    report.lead_notes.push_back(fmt::format("{}: {}.", stand.name, stand.differs));
  }
  report.tables = {stands_table(results.scores), odometry_errors_table(results.scores),
                   odometry_sweeps_table(results.scores), lost_table(results.scores)};
  report.figures = results.figures;
  report.protocol = odometry_protocol();
  report.protocol.push_back(fmt::format(
      "Peak memory of the whole run, stands and rays included: {:.0f} MB.", peak_memory_mb()));
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

std::map<std::string, Metric> odometry_metrics(const std::vector<OdometryScores>& scores) {
  std::map<std::string, Metric> metrics;
  for (const OdometryScores& s : scores) {
    const auto drift = mean_drift(s.sub_paths);
    if (!drift) continue;
    Metric metric;
    metric.value = drift->percent;
    metric.unit = "%";
    metric.n = metric.of = drift->sub_paths;
    metrics[fmt::format("drift_{}_{}", s.stand, s.odometry)] = metric;
  }
  metrics["peak_memory_mb"] = {peak_memory_mb(), "MB", 1, 1, {}, {}};
  return metrics;
}

}  // namespace

RunOutcome run_odometry_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const auto stands = asked_stands(request);
  const TrialRange trials = trials_of(request);
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const OdometryResults results = drive_stands(request, trials, stands, folder.path());

  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&results.trials, &results.sweeps});
  write_trials_h5(folder.path() / "trials.h5", summary.context, results.trials, results.sweeps);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["stands"] = stands_json(results.scores);
  summary.metrics = odometry_metrics(results.scores);
  summary.report = odometry_report(request, results);
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(summary.report.tables.front()), request.out, summary.results_digest};
}

}  // namespace honka::eval
