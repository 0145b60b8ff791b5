// Rows: `bench_slam_methods/…` on case 0 of the shared SLAM data, 2,126 key frames and 228,810
// stems; skipped where it is absent. `whole/<method>` starts from the reference chain.
#include <benchmark/benchmark.h>

#include "algo/slam/slam.h"
#include "tests/support/slam_case.h"

namespace honka {
namespace {

struct MethodsBenchCase {
  std::vector<SparseFrame> frames;
  FramePoses chain, rechain;
  std::vector<PairMatch> matches;
};

const MethodsBenchCase* methods_bench_case(benchmark::State& state) {
  static const MethodsBenchCase kCase = [] {
    MethodsBenchCase c;
    const auto folder = test::shared_slam_cases();
    if (!folder) return c;
    for (auto& points : test::read_frame_points(*folder / "case0_points.csv.gz")) {
      c.frames.push_back({static_cast<std::int64_t>(c.frames.size()), std::move(points)});
    }
    c.chain = test::read_pose_rows(*folder / "case0_chain_pose.csv");
    c.rechain = test::read_pose_rows(*folder / "case0_rechain_pose.csv");
    const auto rows = test::read_number_rows(*folder / "case0_ms_pairs.csv");
    const auto poses = test::read_pose_rows(*folder / "case0_ms_pairs.csv", 2);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      c.matches.push_back({static_cast<std::size_t>(rows[k][1]),
                           static_cast<std::size_t>(rows[k][0]), poses[k], 0.0, 0.0});
    }
    return c;
  }();
  if (!kCase.frames.empty()) return &kCase;
  state.SkipWithError("the shared SLAM cases are absent");
  return nullptr;
}

void bench_rechain(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reregister_chain(c->frames, c->chain, {}, {}, {}));
  }
}

void bench_verified_pairs(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  const VerifiedPairsSettings settings;
  for (auto _ : state) {
    benchmark::DoNotOptimize(find_verified_pairs(c->frames, c->rechain, {}, {}, settings));
  }
}

void bench_interpolate(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  const InterpolatePairsSettings settings;
  for (auto _ : state)
    benchmark::DoNotOptimize(interpolate_pairs(c->rechain, c->matches, settings));
}

FramePoses solved_graph(const MethodsBenchCase& c) {
  auto edges = chain_edges(c.rechain, {}, {});
  const auto more = match_edges(c.matches, {});
  edges.insert(edges.end(), more.begin(), more.end());
  return optimize_pose_graph(c.rechain, edges, {}).T_first_frame;
}

void bench_pose_graph(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  for (auto _ : state) benchmark::DoNotOptimize(solved_graph(*c));
}

void bench_stem_map(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  for (auto _ : state) benchmark::DoNotOptimize(build_stem_map(c->frames, c->rechain, {}));
}

void bench_landmark_ba(benchmark::State& state) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  const FramePoses start = solved_graph(*c);
  for (auto _ : state) benchmark::DoNotOptimize(adjust_landmarks(c->frames, start, {}, {}));
}

void bench_whole_method(benchmark::State& state, const std::string& method) {
  const MethodsBenchCase* c = methods_bench_case(state);
  if (c == nullptr) return;
  SlamSettings settings;
  settings.method = method;
  for (auto _ : state) benchmark::DoNotOptimize(run_slam(c->frames, c->chain, settings));
}

BENCHMARK(bench_rechain)->Name("bench_slam_methods/rechain")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_verified_pairs)
    ->Name("bench_slam_methods/verified_pairs")
    ->Unit(benchmark::kMillisecond);
BENCHMARK(bench_interpolate)->Name("bench_slam_methods/interpolate")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_pose_graph)->Name("bench_slam_methods/pose_graph")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_stem_map)->Name("bench_slam_methods/stem_map")->Unit(benchmark::kMillisecond);
BENCHMARK(bench_landmark_ba)->Name("bench_slam_methods/landmark_ba")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_whole_method, interpolate, "interpolate")
    ->Name("bench_slam_methods/whole/interpolate")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_whole_method, landmark_ba, "landmark_ba")
    ->Name("bench_slam_methods/whole/landmark_ba")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace honka
