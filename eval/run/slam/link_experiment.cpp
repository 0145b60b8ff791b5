#include "eval/run/slam/link_experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "algo/slam/slam.h"
#include "algo/types/user_error.h"
#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/report/summary.h"
#include "eval/run/scenario_json.h"
#include "eval/run/slam/link_figures.h"
#include "eval/run/slam/link_tables.h"

namespace honka::eval {
namespace {

const std::vector<std::string> kLinkSeries = {"bandwidth", "loss", "delay"};

void check_methods(const RunRequest& request) {
  const auto methods = request.resolved.scenario.link.method_list();
  const auto& known = slam_method_names();
  for (const std::string& method : methods) {
    if (std::find(known.begin(), known.end(), method) != known.end()) continue;
    throw UserError(fmt::format("{}: link.study.methods: \"{}\" is not known; it may be {}",
                                request.resolved.file.string(), method, fmt::join(known, ", ")));
  }
  if (methods.empty()) {
    throw UserError(fmt::format("{}: link.study.methods is empty; write \"chain, pose_graph\"",
                                request.resolved.file.string()));
  }
}

std::vector<LinkTrial> run_link_trials(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  std::vector<LinkTrial> trials;
  for (std::int64_t trial = first; trial < end; ++trial) {
    const std::string what = fmt::format("trial {} ({} to {})", trial, first, end - 1);
    const SlamDrive drive = drive_for_slam(scenario, trial, request.threads, what);
    if (drive.frames.empty()) {
      throw UserError(
          fmt::format("{}: trial {} has no key frame; is protocol.path_length_m = {} "
                      "long enough for slam.keyframe.distance_m?",
                      request.resolved.file.string(), trial, scenario.protocol.path_length_m));
    }
    trials.push_back(study_links(drive, scenario, trial, request.threads));
  }
  return trials;
}

ReportModel link_report(const RunRequest& request, const std::vector<LinkTrial>& trials,
                        const std::vector<LinkScores>& scores,
                        const std::filesystem::path& folder) {
  const Scenario& scenario = request.resolved.scenario;
  ReportModel report;
  report.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  report.question = scenario.question;
  report.tables.push_back(link_need_table(trials));
  for (const std::string& series : kLinkSeries) {
    report.tables.push_back(link_series_table(series, scores));
  }
  report.figures = {draw_link_quality(folder / "figures", "bandwidth", scores),
                    draw_link_quality(folder / "figures", "loss", scores)};
  report.protocol = link_protocol();
  report.scenario_text = to_toml(scenario);
  report.reproduce = request.command;
  return report;
}

}  // namespace

RunOutcome run_link_experiment(const RunRequest& request) {
  check_methods(request);
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  const auto trials = run_link_trials(request);
  const auto scores = link_scores(trials);
  Table rows = link_trial_table();
  for (const LinkTrial& trial : trials) append_link_rows(rows, trial);

  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&rows});
  write_trials_h5(folder.path() / "trials.h5", summary.context, rows, Table());
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables["need"] = link_need_json(trials);
  for (const std::string& series : kLinkSeries) {
    summary.tables[series] = link_series_json(series, scores);
  }
  summary.report = link_report(request, trials, scores, folder.path());
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  std::string text;
  for (const ReportTable& table : summary.report.tables) text += console_table(table) + "\n";
  return {text, request.out, summary.results_digest};
}

}  // namespace honka::eval
