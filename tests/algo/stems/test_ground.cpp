#include <catch2/catch.hpp>

#include "algo/stems/ground.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

/// Ground of a slope with waves seen as a lidar sees it: rings that leave gaps, trunks that hang in
/// the gaps without a foot, and a canopy.
std::vector<Eigen::Vector3d> ringed_stand(double slope) {
  RandomStream random(9, "ground");
  std::vector<Eigen::Vector3d> points;
  const auto ground = [&](double x, double y) { return slope * x + 0.2 * std::sin(0.2 * y); };
  for (const double ring_m : {4.0, 5.0, 6.5, 8.0, 10.0, 13.0, 17.0, 24.0, 33.0}) {
    for (double bearing = -3.1; bearing < 3.1; bearing += 0.2 / ring_m) {
      const double x = ring_m * std::cos(bearing), y = ring_m * std::sin(bearing);
      points.emplace_back(x, y, ground(x, y) + random.normal(0.0, 0.02));
    }
  }
  for (int k = 0; k < 60; ++k) {
    const double x = random.uniform(-30.0, 30.0), y = random.uniform(-30.0, 30.0);
    for (double z = 1.5; z < 15.0; z += 0.3) points.emplace_back(x, y, ground(x, y) + z);
  }
  return points;
}

}  // namespace

TEST_CASE("the ground lies under trunks without feet and between rings, on any slope") {
  for (const double slope : {0.0, 0.1, 0.25}) {
    const GroundGrid ground(ringed_stand(slope));
    RandomStream random(10, "places");
    for (int k = 0; k < 300; ++k) {
      const double range = random.uniform(4.0, 30.0), bearing = random.uniform(-3.1, 3.1);
      const double x = range * std::cos(bearing), y = range * std::sin(bearing);
      const double expected = slope * x + 0.2 * std::sin(0.2 * y);
      INFO("slope " << slope << " at " << x << ", " << y);
      CHECK(ground.height_m({x, y}) == Approx(expected).margin(0.35));
    }
  }
}

TEST_CASE("a ground of one point is level with it") {
  const std::vector<Eigen::Vector3d> one = {{5.0, 5.0, 1.25}};
  const GroundGrid ground(one);
  CHECK(ground.height_m({5.0, 5.0}) == 1.25);
  CHECK(ground.height_m({-50.0, 90.0}) == 1.25);
}
