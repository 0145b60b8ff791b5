// Sweeps a second of each lidar odometry over a harvester's work on the default stand.
#include <benchmark/benchmark.h>

#include <ctime>

#include "algo/odometry/odometry.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"
#include "sim/harvester/vehicle.h"
#include "sim/lidar/lidar_simulator.h"

namespace honka {
namespace {

constexpr std::uint64_t kDriveSeed = 1;
constexpr std::int64_t kDriveSweeps = 300;  // 30 s: driving, swings and processing

/// The sweeps of half a minute of work in the middle of the default stand.
const std::vector<Sweep>& drive_sweeps(LidarModel& model) {
  static LidarModel cast_model;
  static const std::vector<Sweep> sweeps = [] {
    const sim::ForestSettings forest;
    const Eigen::AlignedBox2d extent(Eigen::Vector2d(0, 0),
                                     Eigen::Vector2d(forest.width_m, forest.length_m));
    const sim::Polyline path = sim::work_path(extent, 200.0, kDriveSeed);
    const sim::Stand stand = sim::make_stand(forest, {path}, kDriveSeed);
    const sim::World world = sim::make_world(stand, forest, kDriveSeed);
    const sim::Vehicle vehicle(path, stand.terrain, {}, kDriveSeed);
    const sim::LidarSimulator lidar(world, {}, kDriveSeed);
    cast_model = lidar.model();
    std::vector<Sweep> cast;
    for (std::int64_t k = 0; k < kDriveSweeps; ++k) {
      const double middle_s = cast_model.sweep_period_s() * (static_cast<double>(k) + 0.5);
      cast.push_back(
          lidar.cast(vehicle.trajectory(), k, vehicle.occluders_in_lidar(middle_s)).sweep);
    }
    return cast;
  }();
  model = cast_model;
  return sweeps;
}

double odometry_cpu_s() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One core and its own time; the drive from its start, so that the map grows as it does.
void odometry_over_drive(benchmark::State& state, const char* name) {
  LidarModel model;
  const std::vector<Sweep>& sweeps = drive_sweeps(model);
  double spent_s = 0.0, taken = 0.0, registered = 0.0;
  for (auto _ : state) {
    const auto odometry = create_odometry(name, model, {});
    const double start_s = odometry_cpu_s();
    for (const Sweep& sweep : sweeps) {
      const OdometryEstimate estimate = odometry->process(sweep);
      registered += estimate.status <= OdometryStatus::kDegenerate ? 1.0 : 0.0;
    }
    spent_s += odometry_cpu_s() - start_s;
    taken += static_cast<double>(sweeps.size());
  }
  state.counters["sweeps_s"] = taken / spent_s;
  state.counters["real_time_factor"] = model.sweep_period_s() * taken / spent_s;
  state.counters["registered_share"] = registered / taken;
}
BENCHMARK_CAPTURE(odometry_over_drive, loam, "loam")->Unit(benchmark::kMillisecond)->MinTime(2.0);
BENCHMARK_CAPTURE(odometry_over_drive, stems, "stems")->Unit(benchmark::kMillisecond)->MinTime(2.0);

}  // namespace
}  // namespace honka
