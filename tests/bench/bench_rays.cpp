// Ray rates on the default scene, beside bare Embree on the same scene and the same rays.
#include <benchmark/benchmark.h>

#include <ctime>
#include <filesystem>

#include "eval/io/recording.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"
#include "sim/harvester/vehicle.h"
#include "sim/lidar/embree_scene.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/lidar/sweep_poses.h"

namespace honka::sim {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kSweeps = 12;

/// The default stand (200 × 300 m) with the harvester at work in its middle.
struct Scene {
  ForestSettings forest;
  Eigen::AlignedBox2d extent{Eigen::Vector2d(0, 0),
                             Eigen::Vector2d(forest.width_m, forest.length_m)};
  Polyline path = work_path(extent, 200.0, kSeed);
  Stand stand = make_stand(forest, {path}, kSeed);
  World world = make_world(stand, forest, kSeed);
  Vehicle vehicle{path, stand.terrain, VehicleSettings(), kSeed};

  static const Scene& get() {
    static const Scene scene;
    return scene;
  }
  /// Sweeps spread evenly over the drive.
  [[nodiscard]] std::int64_t sweep(int i) const {
    return static_cast<std::int64_t>(10.0 * vehicle.duration_s() * i / kSweeps);
  }
};

double cpu_s() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The rays of a cast sweep as Embree takes them, one a shot.
std::vector<RTCRayHit> rays_of(const Sweep& sweep, const LidarModel& model,
                               const Trajectory& trajectory, double far_m) {
  const SweepPoses poses(trajectory, sweep.start_time_s, model.sweep_period_s() + 1e-3);
  std::vector<RTCRayHit> rays;
  for (const Return& r : sweep.returns) {
    const Eigen::Vector3d d = model.direction(r.laser, sweep.azimuth_rad(r, model));
    const Ray ray = to_world(poses.at(1e-9 * r.time_offset_ns), {0, 0, 0, d.x(), d.y(), d.z()});
    EmbreeScene::aim(rays.emplace_back(), ray, far_m);
  }
  return rays;
}

/// Ready for another cast: Embree shortens a ray to its hit.
void reset(std::vector<RTCRayHit>& rays, double far_m) {
  for (RTCRayHit& ray : rays) {
    ray.ray.tfar = static_cast<float>(far_m);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  }
}

void cast_bare(RTCScene scene, std::vector<RTCRayHit>& rays) {
  for (RTCRayHit& ray : rays) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
  }
  benchmark::DoNotOptimize(rays.data());
}

/// Truth poses of a sweep as `honka simulate` records them: every 10 ms.
eval::SweepKnots knots_of(const Trajectory& trajectory, const Sweep& sweep) {
  eval::SweepKnots knots;
  for (int k = 0; k <= 10; ++k) {
    knots.times_s.push_back(sweep.start_time_s + 0.01 * k);
    knots.T_world_lidar.push_back(trajectory.T_world_lidar(knots.times_s.back()));
  }
  return knots;
}

/// Seconds to cast all sweeps and write them with their truth; the file is removed again.
double record_s(const LidarSimulator& lidar, const Scene& scene) {
  const auto file = std::filesystem::temp_directory_path() / "honka_bench_recording.h5";
  const Trajectory& trajectory = scene.vehicle.trajectory();
  const double start = cpu_s();
  eval::RecordingWriter writer(file, lidar.model(), Pose3::Identity(), {});
  for (int i = 0; i < kSweeps; ++i) {
    const TruthfulSweep sweep = lidar.cast(trajectory, scene.sweep(i));
    const eval::SweepKnots knots = knots_of(trajectory, sweep.sweep);
    writer.append(sweep, knots.T_world_lidar, knots.times_s);
  }
  writer.commit();
  const double spent_s = cpu_s() - start;
  std::filesystem::remove(file);
  return spent_s;
}

/// In turn: all sweeps in full, the same recorded, then their rays bare; one core, its own time.
/// The ratios decide.
void sweeps_beside_bare_embree(benchmark::State& state) {
  const Scene& scene = Scene::get();
  const LidarSettings settings;
  const LidarSimulator lidar(scene.world, settings, kSeed);
  const Trajectory& trajectory = scene.vehicle.trajectory();
  std::vector<std::vector<RTCRayHit>> queries;
  double bare_s = 0.0, full_s = 0.0, recorded_s = 0.0, rays = 0.0, hits = 0.0;
  for (int i = 0; i < kSweeps; ++i) {
    const TruthfulSweep sweep = lidar.cast(trajectory, scene.sweep(i));
    queries.push_back(rays_of(sweep.sweep, lidar.model(), trajectory, settings.max_range_m));
    rays += static_cast<double>(queries.back().size());
    for (const Return& r : sweep.sweep.returns) hits += r.range_ticks > 0 ? 1.0 : 0.0;
  }
  for (auto _ : state) {
    const double start = cpu_s();
    for (int i = 0; i < kSweeps; ++i) {
      benchmark::DoNotOptimize(lidar.cast(trajectory, scene.sweep(i)));
    }
    full_s += cpu_s() - start;
    recorded_s += record_s(lidar, scene);
    for (auto& sweep : queries) reset(sweep, settings.max_range_m);
    const double bare_start = cpu_s();
    for (auto& sweep : queries) cast_bare(lidar.scene().handle(), sweep);
    bare_s += cpu_s() - bare_start;
  }
  const double passes = static_cast<double>(state.iterations());
  state.counters["bare_Mray_s"] = 1e-6 * rays * passes / bare_s;
  state.counters["full_Mray_s"] = 1e-6 * rays * passes / full_s;
  state.counters["ratio"] = bare_s / full_s;
  state.counters["ratio_recorded"] = bare_s / recorded_s;
  state.counters["hit_share"] = hits / rays;
}
BENCHMARK(sweeps_beside_bare_embree)->Unit(benchmark::kMillisecond)->MinTime(3.0);

/// Rays a second over the number of sub-rays a shot, with the machine's own crane in the way.
void sweeps_by_sub_rays(benchmark::State& state) {
  const Scene& scene = Scene::get();
  LidarSettings settings;
  settings.sub_rays = state.range(0);
  settings.return_mode = "dual";
  const LidarSimulator lidar(scene.world, settings, kSeed);
  double rays = 0.0;
  int i = 0;
  for (auto _ : state) {
    const std::int64_t sweep = scene.sweep(i++ % kSweeps);
    const auto occluders = scene.vehicle.occluders_in_lidar(0.1 * static_cast<double>(sweep));
    const TruthfulSweep result = lidar.cast(scene.vehicle.trajectory(), sweep, occluders);
    rays += 0.5 * static_cast<double>(result.sweep.returns.size() *
                                      static_cast<std::size_t>(settings.sub_rays));
  }
  state.counters["Mray_s"] = benchmark::Counter(1e-6 * rays, benchmark::Counter::kIsRate);
}
BENCHMARK(sweeps_by_sub_rays)->Arg(1)->Arg(5)->Arg(9)->Unit(benchmark::kMillisecond);

/// Building the hierarchy over the default scene.
void build_hierarchy(benchmark::State& state) {
  const Scene& scene = Scene::get();
  BuildStatistics statistics;
  for (auto _ : state) {
    const EmbreeScene built(scene.world);
    statistics = built.statistics();
  }
  state.counters["MiB"] = static_cast<double>(statistics.bytes) / 1048576.0;
  state.counters["primitives"] = static_cast<double>(statistics.primitives);
  state.counters["trees"] = static_cast<double>(scene.stand.trees.size());
  state.counters["cones"] = static_cast<double>(scene.world.cones.size());
}
BENCHMARK(build_hierarchy)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace honka::sim
