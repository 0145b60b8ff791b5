#include "eval/run/slam/progress_experiment.h"

#include <fmt/format.h>

#include "algo/slam/correction/update.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/parallel.h"
#include "eval/run/progress.h"
#include "eval/run/scenario_json.h"
#include "eval/run/slam/improvement_trials.h"
#include "eval/run/slam/progress_figures.h"
#include "eval/run/slam/progress_tables.h"

namespace honka::eval {
namespace {

std::vector<ProgressTrack> record_tracks(const RunRequest& request) {
  std::vector<ProgressTrack> tracks;
  const TrialRange trials = trials_of(request);
  for (std::int64_t trial = trials.first; trial < trials.end; ++trial) {
    const ImprovementStart start = improvement_start(request, trial);
    const std::vector<std::string>& sides = update_side_names();
    std::vector<ProgressTrack> of_trial(sides.size());
    Progress progress(fmt::format("trial {}, loop", trial), "sides",
                      static_cast<std::int64_t>(sides.size()));
    for_each_index(sides.size(), request.threads, [&](std::size_t k) {
      of_trial[k] = record_progress(start.drive, start.T_first_frame,
                                    request.resolved.scenario.slam, sides[k], start.seed);
      of_trial[k].trial = trial;
      progress.advance();
    });
    for (ProgressTrack& track : of_trial) tracks.push_back(std::move(track));
  }
  return tracks;
}

ReportModel progress_report(const RunRequest& request, const std::vector<ProgressTrack>& tracks,
                            const std::vector<ProgressClaim>& claims,
                            const std::filesystem::path& folder) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.tables = {progress_table(tracks), progress_claims_table(claims)};
  report.figures = {draw_progress(folder / "figures", tracks)};
  report.protocol = progress_protocol();
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

}  // namespace

RunOutcome run_progress_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const std::vector<ProgressTrack> tracks = record_tracks(request);
  const std::vector<ProgressClaim> claims = judge_claims(tracks);

  Summary summary;
  summary.context = context.entries();
  const Table trials = progress_trial_table(tracks), points = progress_point_table(tracks);
  summary.results_digest = results_digest({&trials, &points});
  write_trials_h5(folder.path() / "trials.h5", summary.context, trials, points);
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["progress"] = progress_json(tracks);
  summary.tables["progress_claims"] = progress_claims_json(claims);
  summary.report = progress_report(request, tracks, claims, folder.path());
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  const auto& tables = summary.report.tables;
  return {console_table(tables[0]) + console_table(tables[1]), request.out, summary.results_digest};
}

}  // namespace honka::eval
