#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "algo/delaunay/delaunay.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

using Points = std::vector<Eigen::Vector2d>;

Points random_points(std::size_t n, std::uint64_t seed, double side_m = 100.0) {
  RandomStream stream(seed, "delaunay_test");
  Points points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = stream.uniform(0.0, side_m);
    points.emplace_back(x, stream.uniform(0.0, side_m));
  }
  return points;
}

Points grid(int columns, int rows, double spacing_m) {
  Points points;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) points.emplace_back(spacing_m * i, spacing_m * j);
  }
  return points;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

std::array<Eigen::Vector2d, 3> corners(const DelaunayGraph& graph, const DelaunayTriangle& t) {
  return {graph.vertices[static_cast<std::size_t>(t.vertices[0])],
          graph.vertices[static_cast<std::size_t>(t.vertices[1])],
          graph.vertices[static_cast<std::size_t>(t.vertices[2])]};
}

/// Convex hull by the monotone chain, boundary points left out.
std::set<std::int32_t> hull_of(const Points& points) {
  std::vector<std::int32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto at = [&](std::int32_t i) { return points[static_cast<std::size_t>(i)]; };
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return std::pair(at(a).x(), at(a).y()) < std::pair(at(b).x(), at(b).y());
  });
  std::set<std::int32_t> hull;
  for (int side = 0; side < 2; ++side) {
    std::vector<std::int32_t> chain;
    for (const std::int32_t i : order) {
      while (chain.size() >= 2 && cross(at(chain.back()) - at(chain[chain.size() - 2]),
                                        at(i) - at(chain.back())) <= 0.0) {
        chain.pop_back();
      }
      chain.push_back(i);
    }
    hull.insert(chain.begin(), chain.end());
    std::reverse(order.begin(), order.end());
  }
  return hull;
}

/// Circumcentre and squared radius.
std::pair<Eigen::Vector2d, double> circle(const std::array<Eigen::Vector2d, 3>& c) {
  const Eigen::Vector2d b = c[1] - c[0];
  const Eigen::Vector2d d = c[2] - c[0];
  const double twice = 2.0 * cross(b, d);
  const Eigen::Vector2d centre((d.y() * b.squaredNorm() - b.y() * d.squaredNorm()) / twice,
                               (b.x() * d.squaredNorm() - d.x() * b.squaredNorm()) / twice);
  return {c[0] + centre, centre.squaredNorm()};
}

void check_neighbours(const DelaunayGraph& graph) {
  for (std::size_t i = 0; i < graph.triangles.size(); ++i) {
    const auto& t = graph.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t a = t.vertices[(k + 1) % 3];
      const std::int32_t b = t.vertices[(k + 2) % 3];
      if (t.neighbours[k] < 0) {
        CHECK(graph.on_hull[static_cast<std::size_t>(a)] == 1);
        CHECK(graph.on_hull[static_cast<std::size_t>(b)] == 1);
        continue;
      }
      const auto& n = graph.triangles[static_cast<std::size_t>(t.neighbours[k])];
      const auto back = std::find(n.neighbours.begin(), n.neighbours.end(), i);
      REQUIRE(back != n.neighbours.end());
      const auto slot = static_cast<std::size_t>(back - n.neighbours.begin());
      CHECK(n.vertices[(slot + 1) % 3] == b);  // the shared edge, run the other way
      CHECK(n.vertices[(slot + 2) % 3] == a);
    }
  }
}

}  // namespace

TEST_CASE("an equilateral triangle of 2 m") {
  const auto graph = build_delaunay({{0, 0}, {2, 0}, {1, std::sqrt(3.0)}});
  REQUIRE(graph.triangles.size() == 1);
  CHECK(graph.triangles[0].area_m2 == Approx(std::sqrt(3.0)));
  CHECK(graph.triangles[0].perimeter_squared_m2 == Approx(36.0));
  CHECK(graph.triangles[0].vertices == std::array<std::int32_t, 3>{0, 1, 2});
  CHECK(graph.triangles[0].neighbours == std::array<std::int32_t, 3>{-1, -1, -1});
  CHECK(graph.on_hull == std::vector<std::uint8_t>{1, 1, 1});
}

TEST_CASE("laws of a Delaunay triangulation") {
  const auto n = GENERATE(std::size_t{3}, std::size_t{4}, std::size_t{10}, std::size_t{200});
  const auto scale = GENERATE(1e-3, 1.0, 1e6);
  const Points points = random_points(n, n, 100.0 * scale);
  const auto graph = build_delaunay(points);

  std::set<std::int32_t> hull;
  for (std::size_t i = 0; i < n; ++i) {
    if (graph.on_hull[i] != 0) hull.insert(static_cast<std::int32_t>(i));
  }
  CHECK(hull == hull_of(points));
  CHECK(graph.triangles.size() == 2 * n - 2 - hull.size());  // Euler
  for (const auto& t : graph.triangles) {
    const auto c = corners(graph, t);
    CHECK(cross(c[1] - c[0], c[2] - c[0]) > 0.0);
    const auto [centre, radius_squared] = circle(c);
    for (const auto& p : points) {
      CHECK((p - centre).squaredNorm() >= radius_squared * (1.0 - 1e-6));
    }
  }
  check_neighbours(graph);
}

TEST_CASE("the order of the input changes indices only") {
  const Points points = GENERATE(random_points(60, 5), grid(7, 6, 2.5));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::rotate(order.begin(), order.begin() + 17, order.end());
  std::reverse(order.begin() + 5, order.end());
  Points shuffled;
  for (const std::size_t i : order) shuffled.push_back(points[i]);

  const auto a = build_delaunay(points);
  const auto b = build_delaunay(shuffled);
  REQUIRE(a.triangles.size() == b.triangles.size());
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    CHECK(a.triangles[i].neighbours == b.triangles[i].neighbours);
    CHECK(a.triangles[i].area_m2 == b.triangles[i].area_m2);
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(points[static_cast<std::size_t>(a.triangles[i].vertices[k])] ==
            shuffled[static_cast<std::size_t>(b.triangles[i].vertices[k])]);
    }
  }
}

TEST_CASE("a grid: points on the sides are on the hull, cells are halved") {
  const auto graph = build_delaunay(grid(5, 4, 3.0));
  CHECK(graph.triangles.size() == 2 * 4 * 3);
  for (const auto& t : graph.triangles) CHECK(t.area_m2 == 4.5);
  CHECK(std::count(graph.on_hull.begin(), graph.on_hull.end(), 1) == 14);
  check_neighbours(graph);
}

TEST_CASE("too few places and points on a line have no triangles") {
  const Points line = {{0, 0}, {1, 2}, {2, 4}, {5, 10}};
  for (const Points& points : {Points{}, Points{{1, 2}}, Points{{1, 2}, {3, 4}},
                               Points{{1, 2}, {1, 2}, {1, 2}, {3, 4}}, line}) {
    const auto graph = build_delaunay(points);
    CHECK(graph.triangles.empty());
    CHECK(graph.vertices.size() == points.size());
    CHECK(graph.on_hull == std::vector<std::uint8_t>(points.size(), 1));
  }
}

TEST_CASE("points at one place are merged into the lowest index") {
  const auto graph = build_delaunay({{0, 0}, {4, 0}, {4, 0}, {0, 4}, {0, 0}, {1, 1}, {1, 1}});
  CHECK(graph.triangles.size() == 3);
  std::set<std::int32_t> used;
  for (const auto& t : graph.triangles) used.insert(t.vertices.begin(), t.vertices.end());
  CHECK(used == std::set<std::int32_t>{0, 1, 3, 5});
  CHECK(graph.on_hull == std::vector<std::uint8_t>{1, 1, 1, 1, 1, 0, 0});
}

TEST_CASE("UTM-sized coordinates keep the triangles and millimetres of their sides") {
  const Points points = random_points(80, 11);
  Points rounded;
  Points far;
  const Eigen::Vector2d utm(654321.0, 6912345.0);
  for (const auto& p : points) {
    const Eigen::Vector2d mm = (p * 1000.0).array().round() / 1000.0;
    rounded.push_back(mm);
    far.push_back(mm + utm);
  }
  const auto near_graph = build_delaunay(rounded);
  const auto far_graph = build_delaunay(far);
  REQUIRE(near_graph.triangles.size() == far_graph.triangles.size());
  for (std::size_t i = 0; i < near_graph.triangles.size(); ++i) {
    CHECK(near_graph.triangles[i].vertices == far_graph.triangles[i].vertices);
    CHECK(std::abs(near_graph.triangles[i].area_m2 - far_graph.triangles[i].area_m2) < 1e-6);
  }
}

TEST_CASE("a coordinate that is not finite is refused with the point's number") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(build_delaunay({{0, 0}, {1, nan}, {2, 2}}), UserError);
  CHECK_THROWS_WITH(build_delaunay({{0, 0}, {1, nan}, {2, 2}}), Catch::Contains("point 2 of 3"));
  CHECK_THROWS_AS(build_delaunay({{INFINITY, 0}, {1, 0}, {2, 2}}), UserError);
}
