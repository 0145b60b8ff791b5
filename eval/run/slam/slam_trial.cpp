#include "eval/run/slam/slam_trial.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "algo/slam/correction/order.h"
#include "algo/slam/slam.h"
#include "algo/types/check.h"
#include "algo/types/random.h"
#include "eval/run/parallel.h"

namespace honka::eval {
namespace {

using SlamClock = std::chrono::steady_clock;

std::string chain_start(double inlier_ratio) { return fmt::format("chain_{}", inlier_ratio); }

/// A start: its poses, and how long the edge or the cloud took for them.
struct SlamStart {
  FramePoses T_first_frame;
  double time_s = 0.0;
};
using SlamStarts = std::map<std::string, SlamStart>;

double seconds_since(SlamClock::time_point start) {
  return std::chrono::duration<double>(SlamClock::now() - start).count();
}

SlamStart chain_of(const SlamDrive& drive, ChainSettings settings, double inlier_ratio) {
  const auto began = SlamClock::now();
  settings.inlier_ratio = inlier_ratio;
  SlamStart start{make_chain(drive.frames, settings).T_first_frame, 0.0};
  start.time_s = seconds_since(began);
  return start;
}

/// The chain of `slam.chain.inlier_ratio` with its steps registered again.
SlamStart reregistered_of(const SlamDrive& drive, const SlamSettings& settings) {
  const auto began = SlamClock::now();
  SlamSettings chain = settings;
  chain.method = "chain";
  chain.start = "rechained";
  SlamStart start{run_slam(drive.frames, std::nullopt, chain).T_first_frame, 0.0};
  start.time_s = seconds_since(began);
  return start;
}

SlamStart make_start(const std::string& name, const SlamDrive& drive, const Scenario& scenario) {
  if (name == "edge") return {drive.edge_T_first_frame, 0.0};
  if (name == "true_poses") return {drive.true_T_first_frame, 0.0};
  if (name == "reregistered") return reregistered_of(drive, scenario.slam);
  std::vector<double> ratios = scenario.slam_study.start_inlier_ratios;
  ratios.push_back(scenario.slam.chain.inlier_ratio);
  for (const double ratio : ratios) {
    if (name == chain_start(ratio)) return chain_of(drive, scenario.slam.chain, ratio);
  }
  HONKA_CHECK(false, "no start of the name " + name);
}

/// The paper's loop in one of its orders.
void run_loop(SlamRun& run, const SlamDrive& drive, const Scenario& scenario, std::uint64_t seed) {
  PaperLoopSettings settings = scenario.slam.loop;
  settings.order = run.treatment;
  PaperLoopResult loop =
      run_paper_loop(drive.frames, run.T_first_frame, scenario.slam.view, settings, seed);
  run.T_first_frame = std::move(loop.T_first_frame);
  run.corrections = loop.applied;
  run.candidates = loop.candidates;
  run.icp_calls = loop.icp_calls;
  run.go_icp_calls = loop.go_icp_calls;
  run.icp_s = loop.icp_s;
  run.go_icp_s = loop.go_icp_s;
}

/// A method from poses that are its start already.
void run_method(SlamRun& run, const SlamDrive& drive, const Scenario& scenario,
                std::uint64_t seed) {
  SlamSettings settings = scenario.slam;
  settings.start = "chain";
  settings.method = run.treatment;
  const std::string kInterpolate = "interpolate_";
  if (run.treatment.starts_with(kInterpolate)) {
    settings.method = "interpolate";
    settings.interpolate.side = run.treatment.substr(kInterpolate.size());
  }
  SlamResult result = run_slam(drive.frames, run.T_first_frame, settings, nullptr, seed);
  run.T_first_frame = std::move(result.T_first_frame);
  run.corrections = static_cast<std::int64_t>(result.corrections);
  run.icp_calls = static_cast<std::int64_t>(result.icp_calls);
  run.go_icp_calls = static_cast<std::int64_t>(result.go_icp_calls);
}

SlamRun run_case(const SlamCase& asked, const SlamStart& start, const SlamDrive& drive,
                 const Scenario& scenario, std::uint64_t seed) {
  SlamRun run;
  run.start = asked.start;
  run.treatment = asked.treatment;
  run.T_first_frame = start.T_first_frame;
  const auto began = SlamClock::now();
  const auto& orders = correction_order_names();
  if (asked.treatment == "none") {
    run.time_s = start.time_s;
  } else if (std::find(orders.begin(), orders.end(), asked.treatment) != orders.end()) {
    run_loop(run, drive, scenario, seed);
    run.time_s = seconds_since(began);
  } else {
    run_method(run, drive, scenario, seed);
    run.time_s = seconds_since(began);
  }
  run.quality = judge_slam(drive, run.T_first_frame, scenario.slam.loop.blur);
  return run;
}

std::vector<SlamCase> table1_cases(const Scenario& scenario) {
  std::vector<std::string> starts;
  for (const double ratio : scenario.slam_study.start_inlier_ratios) {
    starts.push_back(chain_start(ratio));
  }
  if (scenario.slam_study.start_reregistered) starts.emplace_back("reregistered");
  std::vector<SlamCase> cases;
  for (const std::string& start : starts) {
    cases.push_back({start, "none"});
    for (const std::string& order : correction_order_names()) cases.push_back({start, order});
  }
  return cases;
}

std::vector<SlamCase> method_cases(const Scenario& scenario) {
  const std::string chain = chain_start(scenario.slam.chain.inlier_ratio);
  return {{"edge", "none"},
          {chain, "none"},
          {chain, "paper"},
          {"reregistered", "none"},
          {"reregistered", "paper"},
          {"reregistered", "interpolate_right"},
          {"reregistered", "interpolate_left"},
          {"reregistered", "pose_graph"},
          {"reregistered", "landmark_ba"},
          {"true_poses", "landmark_ba"}};
}

/// The paper's: from the start with its blur, in the order that it found best.
std::vector<SlamCase> fig11_cases(const Scenario& scenario) {
  const std::string chain = chain_start(scenario.slam.chain.inlier_ratio);
  return {{chain, "none"}, {chain, scenario.slam.loop.order}};
}

}  // namespace

std::vector<SlamCase> slam_cases(const Scenario& scenario) {
  const std::string& study = scenario.slam_study.study;
  if (study == "methods") return method_cases(scenario);
  if (study == "fig11") return fig11_cases(scenario);
  return table1_cases(scenario);
}

SlamTrial run_slam_trial(SlamDrive drive, const Scenario& scenario, std::int64_t trial,
                         int threads) {
  SlamTrial done;
  done.trial = trial;
  done.drive = std::move(drive);
  if (done.drive.frames.empty()) return done;
  done.stems = score_frames(done.drive, scenario.slam.view, scenario.protocol.stem_gate_m);
  done.floor = judge_slam(done.drive, done.drive.true_T_first_frame, scenario.slam.loop.blur);

  const std::vector<SlamCase> cases = slam_cases(scenario);
  SlamStarts starts;
  for (const SlamCase& asked : cases) starts[asked.start] = {};
  std::vector<SlamStarts::value_type*> wanted;
  for (auto& start : starts) wanted.push_back(&start);
  for_each_index(wanted.size(), threads, [&](std::size_t i) {
    wanted[i]->second = make_start(wanted[i]->first, done.drive, scenario);
  });

  const std::uint64_t seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "slam_loop",
                                         {static_cast<std::uint64_t>(trial)});
  done.runs.resize(cases.size());
  for_each_index(cases.size(), threads, [&](std::size_t i) {
    done.runs[i] = run_case(cases[i], starts.at(cases[i].start), done.drive, scenario, seed);
  });
  return done;
}

}  // namespace honka::eval
