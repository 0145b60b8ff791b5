// Lists of a sensor on a slope, against the trees on it.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/sighting/slope.h"

using namespace honka;
using namespace honka::sim;

namespace {

MappedForest slope_forest() {
  SpacingSettings spacing;
  std::get<Strauss>(spacing.processes).sweeps = 5;
  return std::move(*make_mapped_forest(spacing, 367.0, {}, 1));
}

Eigen::Vector3d foot_of(const SlopedForest& slope, const Eigen::Vector2d& tree_m) {
  return {tree_m.x(), tree_m.y(), slope.height_m(tree_m)};
}

}  // namespace

TEST_CASE("A tree 10 m up a slope of 30° stands 10 m ahead in the sensor's frame") {
  MappedForest one;
  one.trees_m = {{10.0 * std::cos(kPi / 6.0), 0.0}};
  one.standing = one.in_map = {1};
  const SlopedForest slope(one, kPi / 6.0);
  CHECK(slope.height_m(one.trees_m[0]) == Approx(5.0));
  SightingSettings settings;
  settings.noise_m = 0.0;
  const SlopeSighting list = sight_on_slope(slope, Pose2{}, settings, 0.0, 1, 0);
  REQUIRE(list.trees == std::vector<std::int32_t>{0});
  CHECK((list.stems_in_sensor_m[0] - Eigen::Vector3d(10.0, 0.0, 0.0)).norm() < 1e-12);
  // Its axes: x rises, z leans downhill.
  CHECK(list.T_world_sensor.linear()(2, 0) == Approx(0.5));
  CHECK(list.T_world_sensor.linear()(0, 2) == Approx(-0.5));
}

TEST_CASE("A perfect list holds the feet of the trees within range along the ground") {
  const MappedForest forest = slope_forest();
  const double slope_deg = GENERATE(0.0, 10.0, 30.0);
  const SlopedForest slope(forest, deg_to_rad(slope_deg));
  SightingSettings settings;
  settings.noise_m = 0.0;
  for (std::uint64_t q = 0; q < 10; ++q) {
    const Pose2 place = draw_pose(forest, 30.0, 7, q);
    const SlopeSighting list = sight_on_slope(slope, place, settings, 0.0, 7, q);
    CHECK(planar(list.T_world_sensor).translation_m == place.translation_m);
    CHECK(rad_to_deg(std::acos(list.T_world_sensor.linear()(2, 2))) ==
          Approx(slope_deg).margin(1e-5));
    std::size_t expected = 0;
    for (const Eigen::Vector2d& tree : forest.trees_m) {
      const Eigen::Vector3d seen_m = list.T_world_sensor.inverse() * foot_of(slope, tree);
      CHECK(std::abs(seen_m.z()) < 1e-9);
      const double bearing_deg = rad_to_deg(std::atan2(seen_m.y(), seen_m.x()));
      expected += seen_m.norm() < 30.0 && std::abs(bearing_deg) <= 105.0 ? 1 : 0;
    }
    REQUIRE(list.trees.size() == expected);
    for (std::size_t i = 0; i < expected; ++i) {
      const auto& tree = forest.trees_m[static_cast<std::size_t>(list.trees[i])];
      CHECK((list.T_world_sensor * list.stems_in_sensor_m[i] - foot_of(slope, tree)).norm() < 1e-9);
    }
  }
}

TEST_CASE("Heights have their noise, on level ground the rest is the plan's list") {
  const MappedForest forest = slope_forest();
  const SlopedForest level(forest, 0.0);
  SightingSettings settings;
  settings.missed_share = 0.1;
  settings.false_share = 0.2;
  double squares = 0.0, stems = 0.0;
  for (std::uint64_t q = 0; q < 60; ++q) {
    const Pose2 place = draw_pose(forest, 30.0, 7, q);
    const SlopeSighting list = sight_on_slope(level, place, settings, 0.1, 7, q);
    const Sighting in_plan = sight(forest, place, settings, 7, q);
    REQUIRE(list.trees == in_plan.trees);
    for (std::size_t i = 0; i < list.trees.size(); ++i) {
      CHECK(list.stems_in_sensor_m[i].head<2>() == in_plan.stems_in_sensor_m[i]);
      squares += list.stems_in_sensor_m[i].z() * list.stems_in_sensor_m[i].z();
      stems += 1.0;
    }
  }
  REQUIRE(stems > 2000.0);
  CHECK(std::sqrt(squares / stems) == Approx(0.1).margin(0.005));
}
