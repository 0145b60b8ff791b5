#include "eval/run/slam/calls_experiment.h"

#include <fmt/format.h>

#include "algo/slam/chain.h"
#include "algo/slam/paper_loop.h"
#include "algo/slam/registration/register.h"
#include "eval/metrics/statistics.h"
#include "eval/run/progress.h"
#include "eval/run/slam/improvement_trials.h"
#include "eval/run/slam/registration_runs.h"

namespace honka::eval {
namespace {

constexpr std::int64_t kCallsNodeCap = 500000;

constexpr const char* kIcpName = "pcregistericp";
constexpr const char* kGoIcpName = "Go-ICP";
constexpr const char* kCertifyName = "Go-ICP to a certificate";
constexpr const char* kLandmarksName = "landmark voting";

/// What one loop called, and the pairs it chose with the guesses of that moment.
struct LoopCalls {
  PaperLoopResult loop;
  std::vector<RegistrationTask> pairs;
};

LoopCalls run_loop(const ImprovementStart& start, const Scenario& scenario, std::int64_t trial) {
  LoopCalls calls;
  FramePoses before = start.T_first_frame;
  const auto observer = [&](const CorrectionReport& report, const FramePoses& after) {
    const std::size_t j = report.pair.j, i = report.pair.i;
    calls.pairs.push_back({trial, j, i, between(before, j, i)});
    before = after;
  };
  calls.loop = run_paper_loop(start.drive.frames, start.T_first_frame, scenario.slam.view,
                              scenario.slam.loop, start.seed, observer);
  return calls;
}

/// All trials: calls in the loop, and the same calls again one by one.
struct CallsStudy {
  std::vector<double> icp_calls, go_icp_calls;      ///< of each trial
  std::vector<double> icp_loop_ms, go_icp_loop_ms;  ///< mean of a call, of each trial with any
  std::vector<RegistrationSummary> ways;
  std::vector<double> points;  ///< of the source frame of each chosen pair
};

void add_loop_figures(CallsStudy& study, const LoopCalls& calls) {
  const auto add = [](std::int64_t count, double seconds, std::vector<double>& counts,
                      std::vector<double>& means_ms) {
    counts.push_back(static_cast<double>(count));
    if (count > 0) means_ms.push_back(1e3 * seconds / static_cast<double>(count));
  };
  add(calls.loop.icp_calls, calls.loop.icp_s, study.icp_calls, study.icp_loop_ms);
  add(calls.loop.go_icp_calls, calls.loop.go_icp_s, study.go_icp_calls, study.go_icp_loop_ms);
}

void add_ways(CallsStudy& study, const SlamDrive& drive, const LoopCalls& calls,
              const SlamSettings& slam) {
  RegisterSettings settings;
  settings.icp = slam.loop.icp;
  settings.go_icp = slam.loop.go_icp;
  RegisterSettings certify = settings;
  certify.go_icp = GoIcpSettings{};
  certify.go_icp.time_cap_s = 0.0;
  certify.go_icp.node_cap = kCallsNodeCap;
  const auto run = [&](const char* name, const char* method, const RegisterSettings& how) {
    add_runs(study.ways, name,
             run_registrations(drive, calls.pairs,
                               [&](const auto& target, const auto& source, const Pose3& guess) {
                                 return register_clouds(target.points_m, source.points_m, method,
                                                        how, guess, slam.view);
                               }));
  };
  run(kIcpName, "icp", settings);
  run(kGoIcpName, "go_icp", settings);
  run(kCertifyName, "go_icp", certify);
  run(kLandmarksName, "landmarks", settings);
}

CallsStudy study_calls(const RunRequest& request) {
  CallsStudy study;
  const Scenario& scenario = request.resolved.scenario;
  const TrialRange trials = trials_of(request);
  for (std::int64_t trial = trials.first; trial < trials.end; ++trial) {
    const ImprovementStart start = improvement_start(request, trial);
    Progress progress(fmt::format("trial {}, loop", trial), "stages", 2);
    const LoopCalls calls = run_loop(start, scenario, trial);
    progress.advance();
    add_loop_figures(study, calls);
    add_ways(study, start.drive, calls, scenario.slam);
    for (const RegistrationTask& task : calls.pairs) {
      study.points.push_back(static_cast<double>(start.drive.frames[task.source].points_m.size()));
    }
    progress.advance();
  }
  return study;
}

/// What the paper prints of a way; 0 where it has none.
struct PaperCalls {
  double seconds = 0.0, calls = 0.0;
};

PaperCalls paper_calls(const std::string& name) {
  if (name == kGoIcpName) return {0.41, 29.0};
  if (name == kIcpName) return {0.19, 80.0};
  return {};
}

struct LoopColumn {
  const std::vector<double>* calls = nullptr;
  const std::vector<double>* mean_ms = nullptr;
};

LoopColumn in_loop(const CallsStudy& study, const std::string& name) {
  if (name == kGoIcpName) return {&study.go_icp_calls, &study.go_icp_loop_ms};
  if (name == kIcpName) return {&study.icp_calls, &study.icp_loop_ms};
  return {};
}

bool right_run(const RegistrationRun& run) { return run.is_right; }
bool wrong_run(const RegistrationRun& run) { return run.result.usable() && !run.is_right; }

Json calls_json(const CallsStudy& study, const RegistrationSummary& way) {
  const LoopColumn loop = in_loop(study, way.name);
  const auto mean_or_null = [](const std::vector<double>* values) {
    const auto value = values == nullptr ? std::nullopt : mean(*values);
    return value ? Json(*value) : Json();
  };
  Json row = {{"method", way.name}, {"calls", mean_or_null(loop.calls)}};
  if (loop.calls != nullptr) {
    if (const auto interval = bootstrap_mean(*loop.calls)) {
      row["calls_interval"] = {interval->low, interval->high};
    }
  }
  row["loop_ms"] = mean_or_null(loop.mean_ms);
  row["pairs"] = way.runs.size();
  row["time_ms"] = time_json(way);
  row["nodes"] = way.runs.empty() ? Json() : Json(way.mean_nodes());
  row["right"] = way.count(right_run);
  row["wrong"] = way.count(wrong_run);
  const PaperCalls paper = paper_calls(way.name);
  if (paper.calls > 0.0) {
    row["paper"] = {{"calls", paper.calls}, {"time_ms", 1e3 * paper.seconds}};
  }
  return row;
}

std::vector<ReportCell> calls_cells(const CallsStudy& study, const RegistrationSummary& way) {
  const LoopColumn loop = in_loop(study, way.name);
  const PaperCalls paper = paper_calls(way.name);
  const auto shown = [&](const std::vector<double>* values, double printed, int decimals) {
    ReportCell cell{values == nullptr ? "–"
                                      : fixed(mean(*values).value_or(std::nan("")), decimals)};
    if (printed > 0.0) cell.paper = fixed(printed, 0);
    return cell;
  };
  return {{way.name},
          shown(loop.calls, paper.calls, 1),
          shown(loop.mean_ms, 1e3 * paper.seconds, 3),
          {fmt::format("{}", way.runs.size())},
          {way.runs.empty() ? "–"
                            : fixed(way.time_percentile_ms(50.0), 3) + " / " +
                                  fixed(way.time_percentile_ms(95.0), 3)},
          {fixed(way.mean_nodes(), 0)},
          {fmt::format("{} of {}", way.count(right_run), way.runs.size())},
          {fmt::format("{} of {}", way.count(wrong_run), way.runs.size())}};
}

std::vector<std::string> calls_protocol(const CallsStudy& study) {
  return {
      "Calls: mean over the trials, in one run of the loop: ICP for each chosen pair, Go-ICP where "
      "its match does not meet Eq. 27. One call in the loop: mean wall clock there.",
      "Time p50 / p95: all chosen pairs again from the guesses of that moment, one by one on one "
      "thread, by every method, whichever the loop called. The voting uses no guess.",
      "Right: within 0.5 m and 2.5° of the truth; many of these pairs see little of the same, and "
      "the truth may lie outside the ±30° and ±5 m about a drifted guess. Wrong: passed the share "
      "test and not right.",
      fmt::format("Mean number of stems in a frame of these pairs: {:.0f}; the paper "
                  "has 131. Its times are those of Matlab and of a Python package on its machine.",
                  mean(study.points).value_or(0.0)),
  };
}

}  // namespace

RunOutcome run_calls_experiment(const RunRequest& request) {
  const CallsStudy study = study_calls(request);
  RegistrationReport report;
  report.table = "table2";
  report.json.columns = {"method",  "calls", "loop_ms", "pairs",
                         "time_ms", "nodes", "right",   "wrong"};
  report.shown.title = "Table 2: one call, and number of calls";
  report.shown.headers = {{"method"},
                          {"calls"},
                          {"one call in the loop", "ms"},
                          {"pairs"},
                          {"time p50 / p95", "ms"},
                          {"nodes"},
                          {"right"},
                          {"wrong"}};
  for (const RegistrationSummary& way : study.ways) {
    report.json.rows.push_back(calls_json(study, way));
    report.shown.rows.push_back(calls_cells(study, way));
  }
  report.protocol = calls_protocol(study);
  for (const std::string& sentence : report.protocol) report.json.protocol += sentence + " ";
  report.rows = registration_rows(study.ways);
  return write_registration_report(request, report);
}

}  // namespace honka::eval
