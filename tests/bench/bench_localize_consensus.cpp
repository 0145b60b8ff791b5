// The matcher consensus by size of the map, li2020 beside it at the paper's: one frame of 210°, 30
// m, noise 0.15 m, 30 % missed and 10 % false stems.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>

#include "algo/localize/consensus/consensus.h"
#include "algo/localize/li2020/li2020.h"
#include "algo/types/random.h"

namespace {

using namespace honka;
using StemList = std::vector<Eigen::Vector2d>;

constexpr double kDensity_per_m2 = 0.0367;
constexpr std::uint64_t kFrames = 64;

/// A lattice jittered so far that no order is left, at the paper's density.
StemList district(std::int64_t n, std::uint64_t seed = 1) {
  RandomStream stream(seed, "bench_district");
  const double spacing_m = 1.0 / std::sqrt(kDensity_per_m2);
  const auto side = static_cast<std::int64_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  StemList stems;
  for (std::int64_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i % side) + stream.uniform(-0.6, 0.6);
    const double y = static_cast<double>(i / side) + stream.uniform(-0.6, 0.6);
    stems.emplace_back(spacing_m * x, spacing_m * y);
  }
  return stems;
}

StemList frame_at(const StemList& map, std::uint64_t id) {
  RandomStream stream(1, "bench_frame", {id});
  const double middle_m = 0.5 * std::sqrt(static_cast<double>(map.size()) / kDensity_per_m2);
  const Pose2 T_map_local{
      {middle_m * stream.uniform(0.5, 1.5), middle_m * stream.uniform(0.5, 1.5)},
      stream.uniform(-3.0, 3.0)};
  const Pose2 T_local_map = T_map_local.inverse();
  StemList seen;
  for (const Eigen::Vector2d& p : map) {
    if ((p - T_map_local.translation_m).squaredNorm() > 900.0) continue;
    const Eigen::Vector2d q = T_local_map * p;
    if (std::abs(std::atan2(q.y(), q.x())) > 1.83 || stream.uniform() < 0.3) continue;
    const double dx = stream.normal(0.0, 0.15);
    seen.emplace_back(q.x() + dx, q.y() + stream.normal(0.0, 0.15));
  }
  const std::size_t invented = seen.size() / 9;
  for (std::size_t k = 0; k < invented; ++k) {
    const double range_m = 30.0 * std::sqrt(stream.uniform());
    const double bearing = stream.uniform(-1.83, 1.83);
    seen.emplace_back(range_m * std::cos(bearing), range_m * std::sin(bearing));
  }
  return seen;
}

std::vector<StemList> frames_of(const StemList& map) {
  std::vector<StemList> frames;
  for (std::uint64_t k = 0; k < kFrames; ++k) frames.push_back(frame_at(map, k));
  return frames;
}

/// `seen`: the map of the forest that the frames are of.
void run_frames(benchmark::State& state, const Matcher& matcher, const StemList& seen) {
  const auto frames = frames_of(seen);
  std::size_t next = 0;
  double accepted = 0.0;
  double asked = 0.0;
  for (auto _ : state) {
    accepted += matcher.locate(frames[next]).accepted() ? 1.0 : 0.0;
    asked += 1.0;
    next = (next + 1) % frames.size();
  }
  state.counters["accepted"] = accepted / asked;
}

void consensus_index(benchmark::State& state) {
  const StemList map = district(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(ConsensusIndex(map));
}
BENCHMARK(consensus_index)
    ->Arg(2200)
    ->Arg(22000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond);

void consensus_match(benchmark::State& state) {
  const StemList map = district(state.range(0));
  run_frames(state, ConsensusMatcher(std::make_shared<ConsensusIndex>(map), {}), map);
}
BENCHMARK(consensus_match)
    ->Arg(2200)
    ->Arg(22000)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond);

/// Frames of another forest: all of the search, for nothing.
void consensus_refuse(benchmark::State& state) {
  const StemList map = district(state.range(0));
  run_frames(state, ConsensusMatcher(std::make_shared<ConsensusIndex>(map), {}), district(2200, 2));
}
BENCHMARK(consensus_refuse)->Arg(2200)->Arg(22000)->Arg(100000)->Unit(benchmark::kMillisecond);

void li2020_match_beside(benchmark::State& state) {
  const StemList map = district(state.range(0));
  run_frames(state, Li2020Matcher(map, {}), map);
}
BENCHMARK(li2020_match_beside)->Arg(2200)->Unit(benchmark::kMillisecond);

}  // namespace
