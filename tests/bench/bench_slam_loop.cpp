// Rows: `bench_slam_loop/…` on case 0 of the shared SLAM data, 2,126 key frames and 228,810 stems;
// skipped where it is absent.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "algo/slam/chain.h"
#include "algo/slam/correction/power_coefficients.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/clusters.h"
#include "algo/slam/paper_loop.h"
#include "tests/support/slam_case.h"

namespace honka {
namespace {

struct LoopBenchCase {
  std::vector<SparseFrame> frames;
  FramePoses chain, truth;
};

const LoopBenchCase* loop_bench_case(benchmark::State& state) {
  static const LoopBenchCase kCase = [] {
    LoopBenchCase c;
    const auto folder = test::shared_slam_cases();
    if (!folder) return c;
    for (auto& points : test::read_frame_points(*folder / "case0_points.csv.gz")) {
      c.frames.push_back({static_cast<std::int64_t>(c.frames.size()), std::move(points)});
    }
    c.chain = test::read_pose_rows(*folder / "case0_chain_pose.csv");
    c.truth = test::read_pose_rows(*folder / "case0_true_pose.csv");
    return c;
  }();
  if (!kCase.frames.empty()) return &kCase;
  state.SkipWithError("the shared SLAM cases are absent");
  return nullptr;
}

void bench_blur(benchmark::State& state) {
  const LoopBenchCase* c = loop_bench_case(state);
  if (c == nullptr) return;
  const auto map_m = map_points(c->frames, c->chain);
  for (auto _ : state) benchmark::DoNotOptimize(blur(map_m, {}));
}

void bench_clusters(benchmark::State& state) {
  const LoopBenchCase* c = loop_bench_case(state);
  if (c == nullptr) return;
  const auto map_m = map_points(c->frames, c->chain);
  for (auto _ : state) benchmark::DoNotOptimize(registration_noise(map_m, {}));
}

void bench_update(benchmark::State& state) {
  const LoopBenchCase* c = loop_bench_case(state);
  if (c == nullptr) return;
  const Correction correction{500, 700, between(c->truth, 500, 700)};
  for (auto _ : state) {
    FramePoses poses = c->chain;
    const auto shares = power_coefficients(poses, 500, 700, PowerCoefficient::kIndex, {}, {});
    apply_correction(poses, correction, shares, UpdateSide::kRight);
    benchmark::DoNotOptimize(poses.back());
  }
}

void bench_pairs(benchmark::State& state) {
  const LoopBenchCase* c = loop_bench_case(state);
  if (c == nullptr) return;
  std::int64_t found = 0;
  for (auto _ : state) {
    const CandidatePairs pairs = find_candidate_pairs(c->frames, c->chain, {}, {}, {}, {}, 1);
    found = static_cast<std::int64_t>(pairs.promising.size());
  }
  state.counters["promising"] = static_cast<double>(found);
}

void bench_paper_loop(benchmark::State& state) {
  const LoopBenchCase* c = loop_bench_case(state);
  if (c == nullptr) return;
  PaperLoopSettings settings;
  settings.side = state.range(0) == 0 ? "right" : "left";
  PaperLoopResult result;
  for (auto _ : state) result = run_paper_loop(c->frames, c->chain, {}, settings, 1);
  state.counters["corrections"] = static_cast<double>(result.applied);
  state.counters["go_icp_calls"] = static_cast<double>(result.go_icp_calls);
  state.counters["go_icp_s"] = result.go_icp_s;
  state.counters["icp_s"] = result.icp_s;
  state.counters["blur_before"] = result.blur_before;
  state.counters["blur"] = result.blur;
}

BENCHMARK(bench_blur)->Name("slam_loop/blur")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_clusters)->Name("slam_loop/clusters")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_update)->Name("slam_loop/update")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_pairs)->Name("slam_loop/candidate_pairs")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_paper_loop)
    ->Name("slam_loop/paper_loop")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace honka
