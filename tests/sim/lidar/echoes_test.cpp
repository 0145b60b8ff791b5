#include "sim/lidar/echoes.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/user_error.h"
#include "sim/lidar/lidar_simulator.h"
#include "tests/sim/lidar/quiet_sensor.h"

namespace honka::sim {

TEST_CASE("every footprint keeps its energy, its centre and its Gaussian's width") {
  for (const int rays : {1, 5, 9}) {
    double weight = 0, h = 0, v = 0, hh = 0, vv = 0;
    for (const SubRay& ray : footprint(rays, 3.0, 1.5)) {
      weight += ray.weight;
      h += ray.weight * ray.horizontal_rad;
      v += ray.weight * ray.vertical_rad;
      hh += ray.weight * ray.horizontal_rad * ray.horizontal_rad;
      vv += ray.weight * ray.vertical_rad * ray.vertical_rad;
    }
    CHECK(weight == Approx(1.0));
    CHECK(std::fabs(h) < 1e-12);
    CHECK(std::fabs(v) < 1e-12);
    // A quarter of the full 1/e² divergence is one sigma.
    if (rays > 1) CHECK(std::sqrt(hh) == Approx(0.75e-3));
    if (rays > 1) CHECK(std::sqrt(vv) == Approx(0.375e-3));
  }
  CHECK_THROWS_AS(footprint(3, 3.0, 1.5), UserError);
}

TEST_CASE("hits within the pulse melt, others stay apart") {
  const Label stem = {1, Part::kStem}, ground = {-1, Part::kGround};
  std::vector<SubHit> hits = {{10.2, 30, stem}, {20.0, 10, ground}, {10.0, 10, ground}};
  Echoes echoes;
  REQUIRE(form_echoes(hits, 0.4, echoes) == 2);
  const double near = 10 / 100.0, far = 30 / (10.2 * 10.2);
  CHECK(echoes[0].range_m == Approx((near * 10.0 + far * 10.2) / (near + far)));
  CHECK(echoes[0].label == stem);
  CHECK(echoes[0].exact_range_m == 10.2);
  CHECK(echoes[0].brightness == Approx(40.0));
  CHECK(echoes[1].range_m == Approx(20.0));
  CHECK(form_echoes({}, 0.4, echoes) == 0);
}

TEST_CASE("strongest, last and dual report the echoes that the manual says") {
  Echoes echoes;
  echoes[0].energy = 3, echoes[1].energy = 1, echoes[2].energy = 2;
  CHECK(reported(echoes, 3, ReturnMode::kStrongest).first == 0);
  CHECK(reported(echoes, 3, ReturnMode::kLast).first == 2);
  CHECK(reported(echoes, 3, ReturnMode::kDual).first == 0);
  CHECK(reported(echoes, 3, ReturnMode::kDual).second == 2);
  echoes[2].energy = 5;  // the strongest is the last: the second strongest stands beside it
  CHECK(reported(echoes, 3, ReturnMode::kDual).first == 2);
  CHECK(reported(echoes, 3, ReturnMode::kDual).second == 0);
  CHECK(reported(echoes, 1, ReturnMode::kDual).second == 0);
  CHECK_THROWS_AS(return_mode("first"), UserError);
}

TEST_CASE("laws over sub-rays and return modes: last is never nearer, dual holds both") {
  World world;
  for (int i = 0; i < 40; ++i) {
    const double y = -8.0 + 0.4 * i, x = 8.0 + i % 3;
    world.cones.push_back({{x, y, -9}, {x, y, 9}, 0.05, 0.05, {i, Part::kStem}});
  }
  world.cones.push_back({{0, 0, -30}, {0, 0, 30}, 25.0, 25.0, {-1, Part::kWall}});
  const StaticTrajectory still(Pose3::Identity(), 1.0);
  for (const std::int64_t rays : {1, 5, 9}) {
    LidarSettings settings = quiet_sensor();
    settings.sub_rays = rays;
    settings.field_of_view_deg = 90.0;
    const auto cast = [&](const char* mode) {
      settings.return_mode = mode;
      return LidarSimulator(world, settings, 1).cast(still, 0).sweep.returns;
    };
    const auto strongest = cast("strongest"), last = cast("last"), dual = cast("dual");
    REQUIRE(strongest.size() == last.size());
    REQUIRE(dual.size() == 2 * last.size());
    std::size_t apart = 0;
    for (std::size_t i = 0; i < last.size(); ++i) {
      REQUIRE(last[i].range_ticks >= strongest[i].range_ticks);
      CHECK(dual[2 * i] == strongest[i]);
      CHECK(dual[2 * i + 1].echo == 1);
      CHECK(dual[2 * i + 1].time_offset_ns == last[i].time_offset_ns);
      const bool two = dual[2 * i].range_ticks != dual[2 * i + 1].range_ticks;
      apart += two ? 1 : 0;
      if (last[i].range_ticks != strongest[i].range_ticks) {
        CHECK(dual[2 * i + 1].range_ticks == last[i].range_ticks);
      }
    }
    // One ray has one echo; a footprint over an edge has two.
    CHECK((apart > 0) == (rays > 1));
  }
}

TEST_CASE("an edge before a near background melts into a mixed pixel") {
  World world;
  world.cones.push_back({{10, 0, -9}, {10, 0, 9}, 0.1, 0.1, {1, Part::kStem}});
  world.cones.push_back({{0, 0, -30}, {0, 0, 30}, 10.2, 10.2, {-1, Part::kWall}});
  LidarSettings settings = quiet_sensor();
  settings.sub_rays = 9;
  settings.field_of_view_deg = 10.0;
  const LidarSimulator lidar(world, settings, 1);
  const StaticTrajectory still(Pose3::Identity(), 1.0);
  const TruthfulSweep result = lidar.cast(still, 0);
  int mixed = 0;
  for (std::size_t i = 0; i < result.truth.size(); ++i) {
    const double seen = 0.002 * result.sweep.returns[i].range_ticks;
    mixed += std::fabs(seen - result.truth[i].range_m) > 0.01 ? 1 : 0;
  }
  CHECK(mixed > 8);
  CHECK(mixed < 64);
}

}  // namespace honka::sim
