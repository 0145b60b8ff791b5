#include "eval/run/slam/registration_runs.h"

#include <algorithm>
#include <chrono>

#include "eval/io/context.h"
#include "eval/io/safe_file.h"
#include "eval/metrics/statistics.h"
#include "eval/report/console_table.h"
#include "eval/report/html_report.h"
#include "eval/run/scenario_json.h"

namespace honka::eval {
namespace {

constexpr double kRightWithin_m = 0.5, kRightWithin_deg = 2.5;  // as a localization is judged

bool is_right_pose(const Pose3& estimate, const Pose3& truth) {
  const double off_m = (estimate.translation() - truth.translation()).head<2>().norm();
  const double off_rad = std::abs(wrap_to_pi(yaw_of(estimate) - yaw_of(truth)));
  return off_m < kRightWithin_m && off_rad < deg_to_rad(kRightWithin_deg);
}

std::vector<double> times_of(const RegistrationSummary& summary) {
  std::vector<double> times_ms;
  for (const RegistrationRun& run : summary.runs) times_ms.push_back(run.time_ms);
  return times_ms;
}

}  // namespace

std::vector<RegistrationRun> run_registrations(const SlamDrive& drive,
                                               const std::vector<RegistrationTask>& tasks,
                                               const RegisterFrames& register_frames) {
  std::vector<RegistrationRun> runs;
  for (const RegistrationTask& task : tasks) {
    const Pose3 T_target_source =
        drive.true_T_first_frame[task.target].inverse() * drive.true_T_first_frame[task.source];
    RegistrationRun run{task.trial, task.target, task.source, {}, 0.0, false};
    const auto start = std::chrono::steady_clock::now();
    run.result = register_frames(drive.frames[task.target], drive.frames[task.source],
                                 task.T_target_source_guess);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    run.time_ms = time.count();
    run.is_right = is_right_pose(run.result.T_target_source, T_target_source);
    runs.push_back(std::move(run));
  }
  return runs;
}

double RegistrationSummary::mean_nodes() const {
  std::vector<double> nodes;
  for (const RegistrationRun& run : runs) nodes.push_back(static_cast<double>(run.result.nodes));
  return mean(nodes).value_or(0.0);
}

double RegistrationSummary::time_percentile_ms(double percent) const {
  return percentile(times_of(*this), percent).value_or(std::nan(""));
}

double RegistrationSummary::mean_time_ms() const {
  return mean(times_of(*this)).value_or(std::nan(""));
}

std::int64_t RegistrationSummary::count(bool (*holds)(const RegistrationRun& run)) const {
  return std::count_if(runs.begin(), runs.end(), holds);
}

void add_runs(std::vector<RegistrationSummary>& summaries, const std::string& name,
              std::vector<RegistrationRun> runs) {
  auto known = std::find_if(summaries.begin(), summaries.end(),
                            [&](const RegistrationSummary& s) { return s.name == name; });
  if (known == summaries.end()) known = summaries.insert(summaries.end(), {name, {}});
  known->runs.insert(known->runs.end(), runs.begin(), runs.end());
}

Json time_json(const RegistrationSummary& summary) {
  if (summary.runs.empty()) return {};
  return {{"p50", summary.time_percentile_ms(50.0)}, {"p95", summary.time_percentile_ms(95.0)}};
}

Table registration_rows(const std::vector<RegistrationSummary>& summaries) {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  const std::vector<std::string> texts;
  Table table({{"way", "", "how the frames were registered", texts},
               {"trial", "", "trial (seed)", integers},
               {"target", "", "key frame that stays", integers},
               {"source", "", "key frame that is moved", integers},
               {"status", "", "of the registration", texts},
               {"right", "", "1: within 0.5 m and 2.5 degrees of the truth", integers},
               {"certified", "", "1: the gap is closed", integers},
               {"rmse_m", "m", "of the inlier share", numbers},
               {"share", "", "of the source points in view with a partner", numbers},
               {"lower_bound_m", "m", "of the objective in the region", numbers},
               {"nodes", "", "boxes bounded", integers},
               {"time_ms", "ms", "wall clock", numbers, false}});
  for (const RegistrationSummary& summary : summaries) {
    for (const RegistrationRun& run : summary.runs) {
      const Registration& r = run.result;
      table.add_row(summary.name, run.trial, static_cast<std::int64_t>(run.target),
                    static_cast<std::int64_t>(run.source),
                    std::string(registration_status_name(r.status)),
                    std::int64_t{run.is_right ? 1 : 0}, std::int64_t{r.certified ? 1 : 0}, r.rmse_m,
                    r.share, r.lower_bound_m, r.nodes, run.time_ms);
    }
  }
  return table;
}

RunOutcome write_registration_report(const RunRequest& request, const RegistrationReport& report) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);
  Summary summary;
  summary.context = context.entries();
  summary.results_digest = results_digest({&report.rows});
  write_trials_h5(folder.path() / "trials.h5", summary.context, report.rows, Table{});
  summary.scenario = resolved_keys(scenario);
  summary.scenario_hash = request.resolved.hash;
  summary.tables[report.table] = report.json;
  ReportModel& shown = summary.report;
  shown.title = scenario.title.empty() ? request.resolved.name : scenario.title;
  shown.question = scenario.question;
  shown.tables = {report.shown};
  shown.protocol = report.protocol;
  shown.scenario_text = to_toml(scenario);
  shown.reproduce = request.command;
  write_summary(folder.path() / "summary.json", summary);
  rebuild_report(folder.path());
  folder.commit();
  return {console_table(report.shown), request.out, summary.results_digest};
}

}  // namespace honka::eval
