#include <catch2/catch.hpp>
#include <limits>

#include "algo/slam/registration/nearest_stems.h"
#include "tests/algo/slam/core_world.h"

using namespace honka;

namespace {

NearestStem nearest_by_trying(const test::StemPoints& stems, const Eigen::Vector3d& place,
                              bool in_plane) {
  NearestStem best{-1, std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < stems.size(); ++k) {
    const Eigen::Vector3d to = stems[k] - place;
    const double squared = in_plane ? to.head<2>().squaredNorm() : to.squaredNorm();
    if (squared < best.squared_m2) best = {static_cast<std::int32_t>(k), squared};
  }
  return best;
}

void check_all_queries(const test::StemPoints& stems, double reach_m, std::uint64_t id) {
  const NearestStems nearest(stems);
  REQUIRE(nearest.size() == stems.size());
  RandomStream random(7, "queries", {id});
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d place(random.uniform(-reach_m, reach_m),
                                random.uniform(-reach_m, reach_m),
                                random.uniform(-0.1, 0.1) * reach_m);
    const NearestStem truth = nearest_by_trying(stems, place, false);
    CHECK(nearest.nearest(place).index == truth.index);
    CHECK(nearest.nearest(place).squared_m2 == Approx(truth.squared_m2));
    CHECK(nearest.nearest_planar(place.head<2>()).index ==
          nearest_by_trying(stems, place, true).index);
    const auto hint = static_cast<std::int32_t>(random.below(stems.size()));
    const double hint_m2 = (stems[static_cast<std::size_t>(hint)] - place).squaredNorm();
    CHECK(nearest.nearest(place, {hint, hint_m2}).index == truth.index);
  }
}

}  // namespace

TEST_CASE("Nearest stems are those found by trying all") {
  for (const std::size_t count : {1U, 2U, 3U, 17U, 110U, 300U}) {
    check_all_queries(test::random_stems(count, 70.0, count), 80.0, count);
  }
}

TEST_CASE("Nearest stems on lines, at one place and far away") {
  test::StemPoints line, column, equal(20, Eigen::Vector3d(3.0, 4.0, 5.0)), spread;
  for (int k = 0; k < 50; ++k) {
    line.emplace_back(1.7 * k, 0.0, 0.0);
    column.emplace_back(0.0, 0.0, 0.3 * k);
    spread.emplace_back(k * k * k * 10.0, k % 7, 0.0);
  }
  check_all_queries(line, 100.0, 1);
  check_all_queries(column, 20.0, 2);
  check_all_queries(equal, 20.0, 3);
  check_all_queries(spread, 2e6, 4);
}

TEST_CASE("Of equally near stems the first is taken, and no stems give none") {
  const test::StemPoints square = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
  const NearestStems nearest(square);
  CHECK(nearest.nearest({0.0, 0.0, 0.0}).index == 0);
  CHECK(nearest.nearest({1.0, 1.0, 0.0}).index == 0);
  CHECK(nearest.nearest({0.0, 0.0, 0.0}, {3, 2.0}).index == 0);
  const NearestStems none{test::StemPoints{}};
  CHECK(none.nearest({0.0, 0.0, 0.0}).index == -1);
  CHECK(std::isinf(none.nearest_planar({0.0, 0.0}).squared_m2));
}
