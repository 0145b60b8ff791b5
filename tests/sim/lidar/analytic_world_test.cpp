#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "sim/lidar/lidar_simulator.h"
#include "tests/sim/lidar/quiet_sensor.h"

namespace honka::sim {
namespace {

constexpr double kTick_m = 0.002;
const StaticTrajectory kAtOrigin(Pose3::Identity(), 10.0);

World upright_cone(double x_m, double y_m, double radius_m) {
  World world;
  world.cones.push_back(
      {{x_m, y_m, -40.0}, {x_m, y_m, 40.0}, radius_m, radius_m, {7, Part::kStem}});
  return world;
}

double range_of(const Return& r) { return kTick_m * r.range_ticks; }

/// A wall across x = `x_m`, 400 m wide and 200 m high.
World wall(double x_m) {
  TriangleMesh mesh;
  const auto x = static_cast<float>(x_m);
  mesh.vertices_m = {{x, 200, -100}, {x, -200, -100}, {x, -200, 100}, {x, 200, 100}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.label = {-1, Part::kWall};
  World world;
  world.meshes.push_back(mesh);
  return world;
}

}  // namespace

TEST_CASE("one stem at 10 m answers as on paper") {
  constexpr double kDistance_m = 10.0, kRadius_m = 0.1;
  const LidarSimulator lidar(upright_cone(kDistance_m, 0.0, kRadius_m), quiet_sensor(), 1);
  const TruthfulSweep result = lidar.cast(kAtOrigin, 0);
  int hits = 0;
  for (std::size_t i = 0; i < result.sweep.returns.size(); ++i) {
    const Return& r = result.sweep.returns[i];
    const Eigen::Vector3d d =
        lidar.model().direction(r.laser, result.sweep.azimuth_rad(r, lidar.model()));
    // In the plane: (t cos a − D)² + (t sin a)² = R², and t grows by 1 / cos(elevation).
    const double flat = std::hypot(d.x(), d.y());
    const double off = kDistance_m * d.y() / flat;
    const double rest = kRadius_m * kRadius_m - off * off;
    if (d.x() < 0.0 || rest < 0.0) {
      CHECK(r.range_ticks == 0);
      CHECK(result.truth[i].label.part == Part::kNone);
      continue;
    }
    ++hits;
    const double expected = (kDistance_m * d.x() / flat - std::sqrt(rest)) / flat;
    CHECK(std::fabs(range_of(r) - expected) <= kTick_m);
    CHECK(result.truth[i].range_m == Approx(expected).margin(1e-4));
    CHECK(result.truth[i].label == Label{7, Part::kStem});
  }
  CHECK(hits > 16 * 5);
}

TEST_CASE("inside a ring every beam has the ring's range") {
  constexpr double kRadius_m = 20.0;
  const LidarSimulator lidar(upright_cone(0.0, 0.0, kRadius_m), quiet_sensor(), 1);
  const TruthfulSweep result = lidar.cast(kAtOrigin, 3);
  for (const Return& r : result.sweep.returns) {
    const double elevation = lidar.model().lasers[r.laser].elevation_rad;
    CHECK(std::fabs(range_of(r) - kRadius_m / std::cos(elevation)) <= kTick_m);
  }
}

TEST_CASE("a wall answers with its distance along the beam") {
  constexpr double kDistance_m = 12.5;
  const LidarSimulator lidar(wall(kDistance_m), quiet_sensor(), 1);
  const TruthfulSweep result = lidar.cast(kAtOrigin, 0);
  for (const Return& r : result.sweep.returns) {
    const Eigen::Vector3d d =
        lidar.model().direction(r.laser, result.sweep.azimuth_rad(r, lidar.model()));
    const double expected = kDistance_m / d.x();
    if (d.x() <= 0.0 || expected > 100.0) {
      CHECK(r.range_ticks == 0);
    } else {
      CHECK(std::fabs(range_of(r) - expected) <= kTick_m);
      CHECK(std::abs(r.reflectivity - 50.0 * d.x()) <= 1.0);
    }
  }
}

TEST_CASE("returns a ring on a 20 cm stem fall off with range as in the manual's geometry") {
  // 2 asin(R / D) over 0.1991° a firing: 5.8, 2.9, 1.9, 1.2 at 10, 20, 30, 50 m.
  const std::vector<std::pair<double, double>> kExpected = {
      {10.0, 5.8}, {20.0, 2.9}, {30.0, 1.9}, {50.0, 1.2}};
  for (const auto& [distance_m, expected] : kExpected) {
    const LidarSimulator lidar(upright_cone(distance_m, 0.0, 0.1), quiet_sensor(), 1);
    double hits = 0.0;
    constexpr int kSweeps = 40;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      // A turned sensor moves the grid of azimuths over the stem.
      const StaticTrajectory turned(pose_from_rpy({0, 0, 0}, 0, 0, 1e-3 * sweep), 10.0);
      for (const Return& r : lidar.cast(turned, sweep).sweep.returns) {
        hits += r.range_ticks > 0 ? 1.0 : 0.0;
      }
    }
    CHECK(hits / (16.0 * kSweeps) == Approx(expected).margin(0.06));
  }
}

TEST_CASE("the view is a sector ahead") {
  LidarSettings settings = quiet_sensor();
  settings.field_of_view_deg = 90.0;
  const LidarSimulator lidar(upright_cone(0.0, 0.0, 20.0), settings, 1);
  const TruthfulSweep result = lidar.cast(kAtOrigin, 0);
  for (const Return& r : result.sweep.returns) {
    CHECK(std::fabs(result.sweep.azimuth_rad(r, lidar.model())) <= deg_to_rad(45.0) + 1e-7);
  }
  CHECK(result.sweep.returns.size() == Approx(28935.0 / 4).margin(33.0));
  settings.field_of_view_deg = 360.0;
  const LidarSimulator around(upright_cone(0.0, 0.0, 20.0), settings, 1);
  std::size_t rays = 0;
  for (int sweep = 0; sweep < 10; ++sweep)
    rays += around.cast(kAtOrigin, sweep).sweep.returns.size();
  CHECK(static_cast<double>(rays) / 10.0 == Approx(28935.0).margin(1.7));
}

}  // namespace honka::sim
