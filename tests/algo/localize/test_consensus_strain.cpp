// The matcher consensus on lists that were not levelled: a sensor on a slope lists stems too far
// apart along it.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/consensus/consensus.h"
#include "tests/algo/localize/consensus_world.h"

using namespace honka;
using namespace honka::test;

namespace {

/// Along `uphill_rad` of the sensor, distances on the ground in place of those of the plan.
Stems on_slope(Stems stems, double slope_deg, double uphill_rad) {
  const Eigen::Vector2d uphill(std::cos(uphill_rad), std::sin(uphill_rad));
  const double longer = 1.0 / std::cos(deg_to_rad(slope_deg)) - 1.0;
  for (Eigen::Vector2d& p : stems) p += longer * uphill.dot(p) * uphill;
  return stems;
}

}  // namespace

TEST_CASE("consensus: a list from a slope is found, and its strain told") {
  const Stems map = forest(2200, 2);
  const ConsensusMatcher matcher = consensus_of(map);
  const double slope_deg = GENERATE(10.0, 20.0);
  const double shorter = std::cos(deg_to_rad(slope_deg)) - 1.0;
  for (std::uint64_t k = 0; k < 10; ++k) {
    const double uphill_rad = 0.6 * static_cast<double>(k);
    const double c = std::cos(uphill_rad), s = std::sin(uphill_rad);
    const Sighting seen = sight(map, {0.05, 0.1, 0.05}, k);
    const auto answer = matcher.locate(on_slope(seen.stems, slope_deg, uphill_rad));
    REQUIRE(answer.accepted());
    CHECK(shift_between(answer.T_map_local, seen.T_map_local) < 0.1);
    // Of the sensor's x axis in plan, which the slope turns away from uphill
    const double x_axis_rad = std::atan2(shorter * c * s, 1.0 + shorter * c * c);
    const double yaw_rad = seen.T_map_local.yaw_rad + x_axis_rad;
    CHECK(std::abs(wrap_to_pi(answer.T_map_local.yaw_rad - yaw_rad)) < deg_to_rad(0.5));
    const Eigen::Vector3d strain = shorter * Eigen::Vector3d(c * c, s * s, c * s);
    CHECK((answer.strain - strain).norm() < 0.005);
  }
}

TEST_CASE("consensus: a level list has no strain, with a radial bias or without") {
  const Stems map = forest(2200, 2);
  const ConsensusMatcher matcher = consensus_of(map);
  const double bias_m = GENERATE(0.0, 0.1);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const auto answer = matcher.locate(sight(map, {0.05, 0.1, 0.05, 30.0, bias_m}, k).stems);
    REQUIRE(answer.accepted());
    CHECK(answer.strain.isZero(0.0));
  }
}

TEST_CASE("consensus: on a slope too steep it refuses, and is never wrong") {
  const Stems map = forest(2200, 2);
  const ConsensusMatcher matcher = consensus_of(map);
  const double slope_deg = GENERATE(25.0, 30.0, 40.0);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Sighting seen = sight(map, {0.05, 0.1, 0.05}, k);
    const auto answer = matcher.locate(on_slope(seen.stems, slope_deg, 0.3));
    if (answer.accepted()) CHECK(shift_between(answer.T_map_local, seen.T_map_local) < 0.5);
  }
}
