#include "eval/run/star_survival.h"

#include <catch2/catch.hpp>

#include "algo/types/random.h"

using namespace honka;
using honka::eval::star_survival;

namespace {

using Points = std::vector<Eigen::Vector2d>;

/// A lattice of acute triangles, 8 by 8, on coordinates that doubles hold exactly. The triangles
/// that touch no vertex of the border are those of the 6 by 6 lattice inside: 2 · 5 · 5.
constexpr int kSide = 8;
constexpr int kInteriorStars = 50;

Points lattice() {
  Points points;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) points.emplace_back(4.0 * i + 2.0 * j, 3.5 * j);
  }
  return points;
}

std::size_t at(int i, int j) { return static_cast<std::size_t>(kSide * j + i); }

Points seen_from(const Pose2& T_map_local, const Points& points) {
  Points local;
  for (const Eigen::Vector2d& point : points) local.push_back(T_map_local.inverse() * point);
  return local;
}

const Pose2 kShift{{16.0, -8.0}, 0.0};

}  // namespace

TEST_CASE("every star of the same stems survives") {
  const auto graph = build_delaunay(lattice());
  const auto stars = star_survival(graph, graph, Pose2{}, 0.5);
  CHECK(stars.stars == kInteriorStars);
  CHECK(stars.surviving == kInteriorStars);
  const auto local = build_delaunay(seen_from(kShift, lattice()));
  CHECK(star_survival(local, graph, kShift, 0.5).surviving == kInteriorStars);
  // Seen from 3 m beside the truth no stem meets its own.
  CHECK(star_survival(local, graph, {{16.0, -6.3}, 0.0}, 0.5).surviving == 0);
}

TEST_CASE("a stem that the map lacks takes the twelve stars around it") {
  const auto local = build_delaunay(lattice());
  Points points = lattice();
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(at(4, 4)));
  const auto stars = star_survival(local, build_delaunay(points), Pose2{}, 0.5);
  CHECK(stars.stars == kInteriorStars);
  // The six triangles at the stem, and the six across from it, which lose a neighbour.
  CHECK(stars.surviving == kInteriorStars - 12);
}

TEST_CASE("a stem that stands elsewhere in the map counts while it is inside the gate") {
  const auto local = build_delaunay(lattice());
  Points points = lattice();
  points[at(4, 4)].x() += 0.3;
  const auto map = build_delaunay(points);
  CHECK(star_survival(local, map, Pose2{}, 0.5).surviving == kInteriorStars);
  CHECK(star_survival(local, map, Pose2{}, 0.2).surviving == kInteriorStars - 12);
}

TEST_CASE("a map of more stems keeps the stars that nobody stands in") {
  const auto local = build_delaunay(lattice());
  Points points = lattice();
  for (int k = 1; k < 20; ++k) points.emplace_back(-50.0 - 3.0 * k, 7.0 * (k % 5));
  CHECK(star_survival(local, build_delaunay(points), Pose2{}, 0.5).surviving == kInteriorStars);
  // A stem on an edge takes the two triangles there and the stars of the four around them.
  points = lattice();
  points.push_back(0.5 * (points[at(4, 3)] + points[at(3, 4)]));
  CHECK(star_survival(local, build_delaunay(points), Pose2{}, 0.5).surviving == kInteriorStars - 6);
}

TEST_CASE("stars survive a turn of the sensor") {
  Points points;
  RandomStream random(3, "stars");
  for (int k = 0; k < 200; ++k) points.emplace_back(random.uniform(0, 80), random.uniform(0, 80));
  const auto map = build_delaunay(points);
  for (const double yaw_rad : {-3.0, -1.0, 0.4, 2.2}) {
    const Pose2 T_map_local{{40.0, 30.0}, yaw_rad};
    const auto stars =
        star_survival(build_delaunay(seen_from(T_map_local, points)), map, T_map_local, 0.1);
    CHECK(stars.stars > 300);
    CHECK(stars.surviving == stars.stars);
  }
}

TEST_CASE("of no triangles no star survives") {
  const auto graph = build_delaunay(lattice());
  const auto none = build_delaunay({{0.0, 0.0}, {1.0, 0.0}});
  CHECK(star_survival(none, graph, Pose2{}, 0.5).stars == 0);
  CHECK(star_survival(graph, none, Pose2{}, 0.5).surviving == 0);
  CHECK(star_survival({}, {}, Pose2{}, 0.5).stars == 0);
}
