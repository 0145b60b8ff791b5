#include <benchmark/benchmark.h>

#include "algo/odometry/aggregate.h"
#include "algo/stems/extract.h"
#include "tests/algo/stems/analytic.h"

using namespace honka;

namespace {

constexpr double kSensorHeight_m = 2.8;
constexpr std::uint64_t kSeed = 21;

struct Trunk {
  Eigen::Vector2d position_m;
  double radius_m;
};

/// 370 stems/ha within 45 m, no nearer to the road than 2 m.
std::vector<Trunk> trunks() {
  RandomStream random(kSeed, "bench_trunks");
  std::vector<Trunk> stand;
  while (stand.size() < 300) {
    const double x = random.uniform(-45.0, 48.0), y = random.uniform(-45.0, 45.0);
    const double radius = random.uniform(0.06, 0.2);
    if (std::abs(y) > 2.0) stand.push_back({{x, y}, radius});
  }
  return stand;
}

/// Range to the first trunk, to the flat ground, or to foliage above 6 m; 0 for a miss.
double range_of(const std::vector<Trunk>& stand, const Eigen::Vector3d& from_m,
                const Eigen::Vector3d& ray, RandomStream& random) {
  double range = ray.z() < -1e-3 ? -from_m.z() / ray.z() : 200.0;
  const double flat = ray.head<2>().norm();
  const Eigen::Vector2d heading = ray.head<2>() / flat;
  for (const Trunk& trunk : stand) {
    const Eigen::Vector2d d = trunk.position_m - from_m.head<2>();
    const double across = heading.x() * d.y() - heading.y() * d.x();
    const double along = heading.dot(d);
    if (along < 0.0 || std::abs(across) > trunk.radius_m) continue;
    const double depth = std::sqrt(trunk.radius_m * trunk.radius_m - across * across);
    range = std::min(range, (along - depth) / flat);
  }
  if (ray.z() > 0.02) {
    const double foliage = (6.0 - from_m.z()) / ray.z() + random.uniform(0.0, 15.0);
    range = std::min(range, foliage);
  }
  return range > 100.0 ? 0.0 : range + random.normal(0.0, 0.01);
}

/// One revolution, 210° of it ahead, from `x_m` along the road.
Sweep sweep_at(const std::vector<Trunk>& stand, const LidarModel& model, double x_m) {
  RandomStream random(kSeed, "bench_sweep", {static_cast<std::uint64_t>(x_m * 1000.0)});
  Sweep sweep;
  sweep.start_azimuth_rad = deg_to_rad(-105.0);
  const auto firings =
      static_cast<std::uint32_t>(210.0 / 360.0 * model.sweep_period_s() / model.firing_period_s);
  for (std::uint32_t firing = 0; firing < firings; ++firing) {
    for (std::uint8_t laser = 0; laser < 16; ++laser) {
      Return r;
      r.laser = laser;
      r.time_offset_ns = static_cast<std::uint32_t>(
          1e9 * (firing * model.firing_period_s + model.lasers[laser].firing_offset_s));
      const Eigen::Vector3d ray = model.direction(laser, sweep.azimuth_rad(r, model));
      const double range = range_of(stand, {x_m, 0.0, kSensorHeight_m}, ray, random);
      r.range_ticks = static_cast<std::uint16_t>(range / model.range_resolution_m);
      sweep.returns.push_back(r);
    }
  }
  return sweep;
}

struct Drive {
  LidarModel model = vlp16();
  std::vector<Sweep> sweeps;
  std::vector<PosedSweep> posed;

  explicit Drive(std::int64_t frames) {
    const std::vector<Trunk> stand = trunks();
    for (std::int64_t k = 0; k < frames; ++k) {
      sweeps.push_back(sweep_at(stand, model, 0.3 * static_cast<double>(k)));
    }
    for (std::int64_t k = 0; k < frames; ++k) {
      const double x_m = 0.3 * static_cast<double>(k);
      // A hair of motion within the sweep, so that the compensation is part of the time.
      posed.push_back({&sweeps[static_cast<std::size_t>(k)],
                       pose_from_rpy({x_m, 0.0, kSensorHeight_m}, 0.0, 0.0, 0.0),
                       pose_from_rpy({x_m + 1e-4, 0.0, kSensorHeight_m}, 0.0, 0.0, 1e-5)});
    }
  }
  [[nodiscard]] LocalCloud cloud() const {
    return aggregate(posed, model, {}, posed.back().T_odom_start);
  }
};

void bench_aggregate(benchmark::State& state) {
  const Drive drive(state.range(0));
  std::size_t points = 0;
  for (auto _ : state) points = drive.cloud().size();
  state.counters["points"] = static_cast<double>(points);
}

void bench_extract(benchmark::State& state, const StemSettings& settings) {
  const LocalCloud cloud = Drive(state.range(0)).cloud();
  std::size_t stems = 0;
  for (auto _ : state) stems = extract_stems(cloud, settings).stems.size();
  state.counters["points"] = static_cast<double>(cloud.size());
  state.counters["stems"] = static_cast<double>(stems);
}

StemSettings with(const char* search, bool band = false, const char* form = "journal") {
  StemSettings settings;
  settings.search = search;
  settings.height_band = band;
  settings.form = form;
  return settings;
}

}  // namespace

BENCHMARK(bench_aggregate)->Arg(1)->Arg(3)->Arg(5)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_extract, kd_tree, with("kd_tree"))
    ->Arg(1)
    ->Arg(3)
    ->Arg(5)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_extract, voxel_hash, with("voxel_hash"))
    ->Arg(1)
    ->Arg(3)
    ->Arg(5)
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_extract, voxel_hash_band, with("voxel_hash", true))
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bench_extract, voxel_hash_preprint, with("voxel_hash", false, "preprint"))
    ->Arg(10)
    ->Unit(benchmark::kMillisecond);
