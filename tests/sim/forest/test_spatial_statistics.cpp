#include <catch2/catch.hpp>

#include "algo/types/random.h"
#include "sim/forest/spatial_statistics.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

Eigen::AlignedBox2d box(double width, double length) {
  return {Vector2d::Zero(), Vector2d(width, length)};
}

}  // namespace

TEST_CASE("three stems on paper") {
  // Nearest neighbours: 3, 3 and 4 m.
  const std::vector<Vector2d> stems = {{0, 0}, {3, 0}, {3, 4}};
  CHECK(mean_nearest_neighbour_m(stems, box(10, 10)) == Approx(10.0 / 3.0));
  // Donnelly1978: 0.5 √(100/3) + (0.0514 + 0.041/√3) · 40/3 = 2.88675 + 1.00095.
  CHECK(clark_evans(stems, box(10, 10)) == Approx((10.0 / 3.0) / 3.88770).epsilon(1e-4));
}

TEST_CASE("one pair gives the pair correlation known on paper") {
  const std::vector<Vector2d> stems = {{1, 1}, {1, 4}};
  // Two ordered pairs, overlap 10 · 7; density² = 2 · 1 / 100²; ring of 2.5 to 3.5 m.
  const double ring = 3.14159265358979 * (3.5 * 3.5 - 2.5 * 2.5);
  const auto g = pair_correlation(stems, box(10, 10), {3.0, 6.0}, 0.5);
  CHECK(g[0] == Approx(2.0 / 70.0 / (2.0 / 1e4) / ring));
  CHECK(g[1] == 0.0);
}

TEST_CASE("nearest neighbours agree with looking at all pairs") {
  honka::RandomStream stream(7, "points");
  std::vector<Vector2d> stems;
  for (int i = 0; i < 300; ++i) {
    const double x = stream.uniform(0, 50);
    stems.emplace_back(x, stream.uniform(0, 20));
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < stems.size(); ++i) {
    double best = 1e9;
    for (std::size_t j = 0; j < stems.size(); ++j) {
      if (i != j) best = std::min(best, (stems[i] - stems[j]).norm());
    }
    sum += best;
  }
  CHECK(mean_nearest_neighbour_m(stems, box(50, 20)) == Approx(sum / 300.0));
}

TEST_CASE("complete randomness gives 1, a lattice gives 2") {
  std::vector<Vector2d> random, lattice;
  honka::RandomStream stream(11, "points");
  for (int i = 0; i < 4000; ++i) {
    const double x = stream.uniform(0, 200);
    random.emplace_back(x, stream.uniform(0, 200));
  }
  CHECK(clark_evans(random, box(200, 200)) == Approx(1.0).margin(0.03));
  for (const double g : pair_correlation(random, box(200, 200), {2, 5, 10, 20}, 0.5)) {
    CHECK(g == Approx(1.0).margin(0.08));
  }
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) lattice.emplace_back(x + 0.5, y + 0.5);
  }
  CHECK(clark_evans(lattice, box(60, 60)) == Approx(2.0).margin(0.03));
}
