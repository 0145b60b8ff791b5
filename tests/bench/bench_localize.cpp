// Triangulation and the li2020 match at the size of the paper's stand: 200 m × 300 m, 2,200 trees.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "algo/delaunay/delaunay.h"
#include "algo/localize/li2020/li2020.h"
#include "algo/types/random.h"

namespace {

using namespace honka;
using Points = std::vector<Eigen::Vector2d>;

constexpr std::int64_t kMapStems = 2200;

/// Stems at 367 a hectare, at least 1.5 m apart, in a stand of 2:3.
Points stand(std::int64_t n) {
  RandomStream stream(1, "bench_stand", {static_cast<std::uint64_t>(n)});
  const double width_m = 200.0 * std::sqrt(static_cast<double>(n) / kMapStems);
  Points stems;
  while (static_cast<std::int64_t>(stems.size()) < n) {
    const double x = stream.uniform(0.0, width_m);
    const Eigen::Vector2d p(x, stream.uniform(0.0, 1.5 * width_m));
    const bool free = std::none_of(stems.begin(), stems.end(), [&](const Eigen::Vector2d& q) {
      return (p - q).squaredNorm() < 1.5 * 1.5;
    });
    if (free) stems.push_back(p);
  }
  return stems;
}

/// The n stems nearest to the middle, turned, with centimetres of noise.
Points seen(const Points& map, std::int64_t n) {
  const Eigen::Vector2d middle(100.0, 150.0);
  Points near = map;
  std::sort(near.begin(), near.end(), [&](const auto& a, const auto& b) {
    return (a - middle).squaredNorm() < (b - middle).squaredNorm();
  });
  near.resize(static_cast<std::size_t>(n));
  RandomStream stream(1, "bench_noise");
  const Pose2 T_map_local{middle, 0.7};
  for (Eigen::Vector2d& p : near) {
    p = T_map_local.inverse() * p;
    p.x() += stream.normal(0.0, 0.03);
    p.y() += stream.normal(0.0, 0.03);
  }
  return near;
}

void delaunay(benchmark::State& state) {
  const Points points = stand(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(build_delaunay(points));
}
BENCHMARK(delaunay)->Arg(150)->Arg(kMapStems)->Unit(benchmark::kMillisecond);

void li2020_map(benchmark::State& state) {
  const Points map = stand(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Li2020Matcher(map, Li2020Settings{}));
}
BENCHMARK(li2020_map)->Arg(kMapStems)->Unit(benchmark::kMillisecond);

/// Arguments: local stems, tolerance in tenths of m².
void li2020_match(benchmark::State& state) {
  const Points map = stand(kMapStems);
  Li2020Settings settings;
  settings.tolerance_m2 = 0.1 * static_cast<double>(state.range(1));
  const Li2020Matcher matcher(map, settings);
  const Points local = seen(map, state.range(0));
  int matches = 0;
  for (auto _ : state) matches = matcher.locate(local).matches;
  state.counters["matches"] = matches;
}
BENCHMARK(li2020_match)
    ->Args({54, 45})
    ->Args({150, 45})
    ->Args({150, 90})
    ->Unit(benchmark::kMillisecond);

}  // namespace
