// Where a place lies in a map that the mapping run has bent.
#include "eval/run/localize/map_bend.h"

#include <catch2/catch.hpp>

#include "algo/types/random.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// Trees about the origin, and a map that is off by a pose of its own.
std::pair<StemMap, TrunkMap> bent_map(const Pose2& T_map_world, int trees) {
  RandomStream stream(3, "bent_map");
  StemMap truth;
  TrunkMap map;
  for (int i = 0; i < trees; ++i) {
    const double x_m = stream.uniform(-40.0, 40.0);
    truth.emplace_back().position_m = {x_m, stream.uniform(-40.0, 40.0)};
    ObservedStem stem;
    stem.position_m = T_map_world * truth.back().position_m;
    map.stems.push_back(stem);
  }
  return {truth, map};
}

}  // namespace

TEST_CASE("a map that is off as a whole shows how") {
  const Pose2 T_map_world{{0.1, -0.05}, deg_to_rad(0.2)};
  const auto [truth, map] = bent_map(T_map_world, 60);
  const auto found = map_bend(map, truth, {2.0, 3.0}, 0.5);
  REQUIRE(found);
  CHECK((found->translation_m - T_map_world.translation_m).norm() < 1e-6);
  CHECK(found->yaw_rad == Approx(T_map_world.yaw_rad).margin(1e-8));
}

TEST_CASE("far from the map, or with a few trees, nothing can be said") {
  const auto [truth, map] = bent_map({}, 60);
  CHECK_FALSE(map_bend(map, truth, {500.0, 0.0}, 0.5));
  const auto [few_trees, few_stems] = bent_map({}, 5);
  CHECK_FALSE(map_bend(few_stems, few_trees, {0.0, 0.0}, 0.5));
}
