// The units of SLAM at the size of the paper's frames: about 110 stems a frame, 2,126 key frames.
#include <benchmark/benchmark.h>

#include "algo/geometry/se3_power.h"
#include "algo/slam/chain.h"
#include "algo/slam/convergence.h"
#include "algo/slam/match_quality.h"
#include "algo/types/random.h"

namespace {

using namespace honka;
using StemCloud = std::vector<Eigen::Vector3d>;

constexpr std::size_t kChainFrames = 2126;

/// Stems at 0.05/m² along a road of 130 m, as many as a frame sees of 0.094/m².
StemCloud road_stems() {
  RandomStream random(1, "bench_road_stems");
  StemCloud stems;
  for (int k = 0; k < 1000; ++k) {
    stems.emplace_back(random.uniform(-40.0, 170.0), random.uniform(-48.0, 48.0),
                       random.normal(0.0, 0.5));
  }
  return stems;
}

/// Key frame l, a sixteenth of a metre after the one before, with the noise of a stem.
SparseFrame road_frame(const StemCloud& stems, std::size_t l) {
  RandomStream random(1, "bench_road_frame", {l});
  const double way_m = 0.0625 * static_cast<double>(l);
  const Pose3 T_world_lidar = pose_from_rpy({way_m, 0.0, 0.0}, 0.0, 0.0, 0.3 * std::sin(way_m));
  SparseFrame frame{static_cast<std::int64_t>(l), {}};
  for (const Eigen::Vector3d& stem : stems) {
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d point = T_world_lidar.inverse() * stem + 0.07 * noise;
    if (ViewCone{}.holds(point.head<2>())) frame.points_m.push_back(point);
  }
  frame.points_m.resize(std::min<std::size_t>(frame.points_m.size(), 110));
  return frame;
}

void slam_power_constants(benchmark::State& state) {
  const Pose3 pose = pose_from_rpy({1.0, 2.0, 0.1}, 0.02, 0.01, 0.4);
  for (auto _ : state) benchmark::DoNotOptimize(pose_power(pose, 0.37));
}
BENCHMARK(slam_power_constants)->Unit(benchmark::kNanosecond);

void slam_power(benchmark::State& state) {
  const PosePower power(pose_from_rpy({1.0, 2.0, 0.1}, 0.02, 0.01, 0.4));
  double u = 0.0;
  for (auto _ : state) benchmark::DoNotOptimize(power(u += 1e-6));
}
BENCHMARK(slam_power)->Unit(benchmark::kNanosecond);

void slam_trimmed_icp(benchmark::State& state) {
  const StemCloud stems = road_stems();
  const auto gap = static_cast<std::size_t>(state.range(0));
  std::vector<SparseFrame> targets, sources;
  for (std::size_t l = 0; l < 50; ++l) {
    targets.push_back(road_frame(stems, 40 * l));
    sources.push_back(road_frame(stems, 40 * l + gap));
  }
  TrimmedIcpSettings settings;
  std::int64_t steps = 0, points = 0;
  std::size_t k = 0;
  for (auto _ : state) {
    const Registration icp = trimmed_icp(targets[k % 50].points_m, sources[k % 50].points_m,
                                         Pose3::Identity(), settings);
    steps += icp.iterations;
    points += static_cast<std::int64_t>(sources[k % 50].points_m.size());
    ++k;
  }
  state.counters["steps"] = static_cast<double>(steps) / static_cast<double>(k);
  state.counters["points"] = static_cast<double>(points) / static_cast<double>(k);
}
BENCHMARK(slam_trimmed_icp)->Arg(1)->Arg(8)->Unit(benchmark::kMicrosecond);

void slam_nearest_stems(benchmark::State& state) {
  const StemCloud points = road_frame(road_stems(), 100).points_m;
  for (auto _ : state) benchmark::DoNotOptimize(NearestStems(points));
}
BENCHMARK(slam_nearest_stems)->Unit(benchmark::kMicrosecond);

void slam_match_quality(benchmark::State& state) {
  const StemCloud stems = road_stems();
  const StemCloud target = road_frame(stems, 100).points_m;
  const StemCloud source = road_frame(stems, 180).points_m;
  const Pose3 T_target_source = pose_from_rpy({5.0, 0.0, 0.0}, 0.0, 0.0, 0.0);
  for (auto _ : state) {
    benchmark::DoNotOptimize(judge_match(target, source, T_target_source, ViewCone{}, {}));
  }
}
BENCHMARK(slam_match_quality)->Unit(benchmark::kMicrosecond);

void slam_view_overlap(benchmark::State& state) {
  const ViewOverlap overlap(ViewCone{});
  Pose2 pose{{5.0, 3.0}, 0.4};
  for (auto _ : state) benchmark::DoNotOptimize(overlap(pose));
}
BENCHMARK(slam_view_overlap)->Unit(benchmark::kNanosecond);

void slam_chain(benchmark::State& state) {
  const StemCloud stems = road_stems();
  std::vector<SparseFrame> frames;
  for (std::size_t l = 0; l < kChainFrames; ++l) frames.push_back(road_frame(stems, l));
  ChainSettings settings;
  settings.inlier_ratio = 0.01 * static_cast<double>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(make_chain(frames, settings));
}
BENCHMARK(slam_chain)->Arg(40)->Arg(95)->Unit(benchmark::kMillisecond);

void slam_mean_neighbour_distance(benchmark::State& state) {
  const StemCloud points = road_frame(road_stems(), 100).points_m;
  for (auto _ : state) benchmark::DoNotOptimize(mean_neighbour_distance_m(points));
}
BENCHMARK(slam_mean_neighbour_distance)->Unit(benchmark::kMicrosecond);

}  // namespace
