// Registration of two key frames of about 110 stems: Go-ICP in both modes by the part of the source
// points that have a partner, and landmark voting. Guesses are off by up to 30° and 5 m.
#include <benchmark/benchmark.h>

#include "algo/slam/registration/go_icp.h"
#include "algo/slam/registration/landmark_voting.h"
#include "algo/types/random.h"

namespace {

using namespace honka;
using StemView = std::vector<Eigen::Vector3d>;

constexpr std::uint64_t kViewPairs = 40;
constexpr double kStemsPerM2 = 0.094;  // Nevalainen2021 §3: 680 in 180 × 40 m
constexpr double kStandHalf_m = 75.0;
constexpr double kSeen = 0.75;  // part of the stems in the cone that a frame sees

/// A pair of views of one stand.
struct ViewPair {
  StemView target_m, source_m;
  Pose3 guess = Pose3::Identity();
};

/// What the scanner sees from a pose: stems in its cone, some of them hidden, with noise.
StemView view_of_stand(const std::vector<Eigen::Vector2d>& stand, const Pose2& T_world_lidar,
                       RandomStream& random) {
  StemView points;
  for (const Eigen::Vector2d& stem : stand) {
    const Eigen::Vector2d place = T_world_lidar.inverse() * stem;
    if (!ViewCone{}.holds(place) || random.uniform() > kSeen) continue;
    points.emplace_back(place.x() + random.normal(0.0, 0.07), place.y() + random.normal(0.0, 0.07),
                        random.normal(0.0, 0.1));
  }
  points.resize(std::min<std::size_t>(points.size(), 130));
  return points;
}

/// Views `apart_m` from each other.
ViewPair make_view_pair(double apart_m, std::uint64_t id) {
  RandomStream random(1, "bench_view_pair", {id});
  std::vector<Eigen::Vector2d> stand;
  const double area_m2 = 4.0 * kStandHalf_m * kStandHalf_m;
  for (int k = 0; k < static_cast<int>(kStemsPerM2 * area_m2); ++k) {
    stand.emplace_back(random.uniform(-kStandHalf_m, kStandHalf_m),
                       random.uniform(-kStandHalf_m, kStandHalf_m));
  }
  const Pose2 T_target_source{{apart_m, 0.0}, random.uniform(-0.2, 0.2)};
  ViewPair pair;
  pair.target_m = view_of_stand(stand, {}, random);
  pair.source_m = view_of_stand(stand, T_target_source, random);
  pair.guess = pose_from_rpy({apart_m + random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), 0.0},
                             0.0, 0.0, T_target_source.yaw_rad + random.uniform(-0.5236, 0.5236));
  return pair;
}

std::vector<ViewPair> make_view_pairs(double apart_m) {
  std::vector<ViewPair> pairs;
  for (std::uint64_t id = 0; id < kViewPairs; ++id) pairs.push_back(make_view_pair(apart_m, id));
  return pairs;
}

/// Argument: metres between the views, whose overlap falls with it.
void slam_go_icp(benchmark::State& state, const char* mode) {
  const auto pairs = make_view_pairs(static_cast<double>(state.range(0)));
  GoIcpSettings settings;
  settings.mode = mode;
  std::size_t k = 0;
  double nodes = 0.0, registered = 0.0, certified = 0.0, share = 0.0;
  for (auto _ : state) {
    const ViewPair& pair = pairs[k++ % pairs.size()];
    const auto result = go_icp(pair.target_m, pair.source_m, pair.guess, settings, ViewCone{});
    nodes += static_cast<double>(result.nodes);
    registered += result.usable() ? 1.0 : 0.0;
    certified += result.certified ? 1.0 : 0.0;
    share += static_cast<double>(result.inliers) / static_cast<double>(pair.source_m.size());
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  state.counters["nodes"] = benchmark::Counter(nodes, mean);
  state.counters["registered"] = benchmark::Counter(registered, mean);
  state.counters["certified"] = benchmark::Counter(certified, mean);
  state.counters["partners"] = benchmark::Counter(share, mean);
}
BENCHMARK_CAPTURE(slam_go_icp, certify, "certify")
    ->Arg(1)
    ->Arg(8)
    ->Arg(16)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(slam_go_icp, l0, "l0")->Arg(1)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

void slam_landmarks(benchmark::State& state) {
  const auto pairs = make_view_pairs(static_cast<double>(state.range(0)));
  std::size_t k = 0;
  double registered = 0.0;
  for (auto _ : state) {
    const ViewPair& pair = pairs[k++ % pairs.size()];
    const auto result = register_by_landmarks(pair.target_m, pair.source_m, {}, ViewCone{});
    registered += result.usable() ? 1.0 : 0.0;
  }
  state.counters["registered"] = benchmark::Counter(registered, benchmark::Counter::kAvgIterations);
}
BENCHMARK(slam_landmarks)->Arg(1)->Arg(8)->Arg(16)->Unit(benchmark::kMicrosecond);

}  // namespace
