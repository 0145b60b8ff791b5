#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "algo/localize/li2020/pairing.h"
#include "algo/localize/li2020/star.h"
#include "algo/localize/li2020/star_index.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A star whose features are plain numbers: centre (10, 100), neighbours (1, 20), (2, 30), (3, 40).
TriangleStar plain_star() {
  TriangleStar star;
  star.triangle = 0;
  star.vertices = {0, 1, 2, 3, 4, 5};
  star.area_m2 = {10, 1, 2, 3};
  star.perimeter_squared_m2 = {100, 20, 30, 40};
  return star;
}

TriangleStar turned(TriangleStar star, std::size_t by) {
  const TriangleStar from = star;
  for (std::size_t k = 0; k < 3; ++k) {
    star.area_m2[(k + by) % 3 + 1] = from.area_m2[k + 1];
    star.perimeter_squared_m2[(k + by) % 3 + 1] = from.perimeter_squared_m2[k + 1];
  }
  return star;
}

/// A central triangle of sides 3, 4, 5 m with an apex outside each side; counter-clockwise.
Points six_points() { return {{0, 0}, {4, 0}, {0, 3}, {8, 6}, {-8, 3}, {3, -9}}; }

TriangleStar star_of(const Points& points) {
  const auto stars = stars_of(build_delaunay(points), StarChoice::kNoHullVertex);
  REQUIRE(stars.size() == 1);
  return stars[0];
}

}  // namespace

TEST_CASE("Li2020 Eq. (1): the features of a star are those of its four triangles") {
  const TriangleStar star = star_of(six_points());
  CHECK(star.area_m2[0] == Approx(6.0));
  CHECK(star.perimeter_squared_m2[0] == Approx(144.0));
  for (std::size_t k = 0; k < 3; ++k) {
    if (star.vertices[k] != 0) continue;  // across from the right angle: the side of 5 m
    CHECK(star.vertices[k + 3] == 3);
    CHECK(star.area_m2[k + 1] == Approx(18.0));
  }
}

TEST_CASE("a local star touches no hull vertex, a map star has three neighbours") {
  Points points = six_points();
  CHECK(stars_of(build_delaunay(points), StarChoice::kNoHullVertex).size() == 1);
  points.resize(5);
  CHECK(stars_of(build_delaunay(points), StarChoice::kNoHullVertex).empty());
  CHECK(stars_of(build_delaunay({{0, 0}, {1, 0}, {0, 1}}), StarChoice::kThreeNeighbours).empty());
}

TEST_CASE("stars are compared at the best of three rotations") {
  const TriangleStar star = plain_star();
  for (const std::size_t by : {0U, 1U, 2U}) {
    const auto like = compare_stars(star, turned(star, by), 1e-9, 3);
    REQUIRE(like);
    CHECK(like->rotation == static_cast<int>(by));
    CHECK(like->dissimilarity_m2 == 0.0);
  }
}

TEST_CASE("a mirrored star is no match") {
  TriangleStar mirrored = plain_star();
  std::swap(mirrored.area_m2[1], mirrored.area_m2[2]);
  std::swap(mirrored.perimeter_squared_m2[1], mirrored.perimeter_squared_m2[2]);
  CHECK_FALSE(compare_stars(plain_star(), mirrored, 4.5, 3));
}

TEST_CASE("the tolerance holds for the centre and each neighbour apart, the total is their sum") {
  const TriangleStar star = plain_star();
  TriangleStar other = star;
  other.area_m2[0] += 1.0;
  other.perimeter_squared_m2[0] -= 1.5;
  other.perimeter_squared_m2[2] += 2.5;
  const auto like = compare_stars(star, other, 2.5, 3);
  REQUIRE(like);
  CHECK(like->dissimilarity_m2 == Approx(5.0));
  CHECK(centre_dissimilarity_m2(star, other) == Approx(2.5));
  CHECK_FALSE(compare_stars(star, other, 2.499, 3));
  other.perimeter_squared_m2[2] += 0.1;
  CHECK_FALSE(compare_stars(star, other, 2.5, 3));
  CHECK(compare_stars(star, other, 2.5, 2));
}

TEST_CASE("the index finds exactly what comparing with all finds") {
  RandomStream stream(3, "star_index_test");
  Points points;
  for (int i = 0; i < 300; ++i) {
    const double x = stream.uniform(0.0, 80.0);
    points.emplace_back(x, stream.uniform(0.0, 80.0));
  }
  const auto stars = stars_of(build_delaunay(points), StarChoice::kThreeNeighbours);
  const StarIndex index(stars);
  const double tolerance_m2 = GENERATE(0.0, 1e-9, 4.5, 60.0, 1e5);
  for (const auto& local : stars) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < stars.size(); ++i) {
      if (centre_dissimilarity_m2(local, stars[i]) <= tolerance_m2) all.push_back(i);
    }
    std::vector<std::size_t> found;
    index.find(local, tolerance_m2, found);
    CHECK(found == all);
  }
}

TEST_CASE("Li2020 Eq. (2): both pairings find the vertices of a turned and moved star") {
  const auto pairing = GENERATE(Pairing::kSimilarEdge, Pairing::kLeastSideSum);
  const double angle = GENERATE(0.0, 0.5, 2.0, -3.0);
  const Points local = six_points();
  Points map;
  for (const std::size_t i : {4U, 2U, 5U, 0U, 3U, 1U}) {  // other indices than the local list
    map.emplace_back(Eigen::Rotation2Dd(angle) * local[i] + Eigen::Vector2d(30, -7));
  }
  const auto pairs = pair_vertices(star_of(local), local, star_of(map), map, pairing);
  for (const VertexPair& p : pairs) {
    const Eigen::Vector2d expected =
        Eigen::Rotation2Dd(angle) * local[static_cast<std::size_t>(p.local)] +
        Eigen::Vector2d(30, -7);
    CHECK((map[static_cast<std::size_t>(p.map)] - expected).norm() < 1e-12);
  }
}

TEST_CASE("the similar edge can mislead where the least side sum does not") {
  // Noise made the local side of 7 m the map's 7.5 m, and the side of 6 m the map's 7 m.
  const auto triangle = [](double a, double b, double c) {
    const double x = (b * b + c * c - a * a) / (2.0 * c);
    return Points{{0, 0}, {c, 0}, {x, std::sqrt(b * b - x * x)}};
  };
  TriangleStar star;
  star.vertices = {0, 1, 2, 0, 0, 0};
  const Points local = triangle(5.0, 6.0, 7.0);
  const Points map = triangle(5.4, 7.0, 7.5);  // the same corners, each side longer
  const auto literal = pair_vertices(star, local, star, map, Pairing::kSimilarEdge);
  const auto least = pair_vertices(star, local, star, map, Pairing::kLeastSideSum);
  CHECK(least[0] == VertexPair{0, 0});
  CHECK(literal[0] == VertexPair{0, 2});  // side c of the local, side b of the map
}
