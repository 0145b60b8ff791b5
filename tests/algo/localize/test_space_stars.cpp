// Stars in space: what they measure does not feel a tilt.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/li2020/selection.h"
#include "algo/localize/li2020/star.h"
#include "algo/localize/li2020/star_graph.h"
#include "algo/localize/li2020/star_pose.h"
#include "algo/localize/matcher.h"
#include "tests/support/space_world.h"

using namespace honka;
using namespace honka::test;

namespace {

Pose3 any_motion(RandomStream& random) {
  const double roll = random.uniform(-kPi, kPi);
  const double pitch = random.uniform(-1.5, 1.5);
  const double yaw = random.uniform(-kPi, kPi);
  const double x = random.uniform(-500.0, 500.0);
  return pose_from_rpy({x, -0.7 * x, 0.3 * x}, roll, pitch, yaw);
}

/// Triangles by their corners alone, three stems each.
DelaunayGraph loose_triangles(std::size_t stems) {
  DelaunayGraph graph;
  for (std::size_t i = 0; i + 2 < stems; i += 3) {
    const auto first = static_cast<std::int32_t>(i);
    graph.triangles.push_back({{first, first + 1, first + 2}, {-1, -1, -1}, 0.0, 0.0});
  }
  return graph;
}

/// Triangles of every kind: at random of every size, on a line, on one place, steep, far and tiny.
SpacePoints corners_of_every_kind() {
  RandomStream random(11, "space_star_corners");
  SpacePoints corners;
  for (int k = 0; k < 900; ++k) {
    const double size = std::pow(10.0, -3.0 + 0.02 * (k / 3));
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    corners.emplace_back(x, y, random.uniform(-size, size));
  }
  const SpacePoints odd = {{0, 0, 0},  {1, 2, 3},       {2, 4, 6},   {5, 5, 5},
                           {5, 5, 5},  {5, 5, 5},       {0, 0, 0},   {0, 0, 9},
                           {0, 4, -9}, {1e4, -1e4, 50}, {1e4, 1, 0}, {0, 0, 1}};
  corners.insert(corners.end(), odd.begin(), odd.end());
  return corners;
}

}  // namespace

TEST_CASE("Li2020 Eq. (1) in space: no rigid motion changes what a triangle measures") {
  const SpacePoints corners = corners_of_every_kind();
  DelaunayGraph still = loose_triangles(corners.size());
  DelaunayGraph moving = still;
  measure_in_space(still, corners);
  RandomStream random(12, "space_star_motions");
  for (int k = 0; k < 50; ++k) {
    const Pose3 T = any_motion(random);
    measure_in_space(moving, moved_in_space(T, corners));
    for (std::size_t i = 0; i < still.triangles.size(); ++i) {
      const DelaunayTriangle& a = still.triangles[i];
      const DelaunayTriangle& b = moving.triangles[i];
      // Coordinates of 1e3 m hold 1e-12 m or so, which sides of this length multiply.
      const double margin_m2 = 1e-10 * (1.0 + a.perimeter_squared_m2);
      CHECK(std::abs(a.area_m2 - b.area_m2) < margin_m2);
      CHECK(std::abs(a.perimeter_squared_m2 - b.perimeter_squared_m2) < margin_m2);
    }
  }
}

TEST_CASE("Stars in space on flat ground are those in the plane, to the last digit") {
  SpacePoints stems = stems_on(flat_ground);
  stems.push_back(stems[7]);  // a copy, and three on a line
  for (int k = 0; k < 3; ++k) stems.emplace_back(100.0 + k, 40.0, 0.0);
  const auto space = stars_of(star_graph<3>(stems).delaunay, StarChoice::kThreeNeighbours);
  const auto plane = stars_of(build_delaunay(plan_of(stems)), StarChoice::kThreeNeighbours);
  REQUIRE(space.size() == plane.size());
  REQUIRE(space.size() > 700);
  for (std::size_t i = 0; i < space.size(); ++i) {
    CHECK(space[i].vertices == plane[i].vertices);
    CHECK(space[i].area_m2 == plane[i].area_m2);
    CHECK(space[i].perimeter_squared_m2 == plane[i].perimeter_squared_m2);
  }
}

TEST_CASE("A triangle of 3, 4 and 5 m that stands upright measures 6 m² and 144 m²") {
  DelaunayGraph graph = loose_triangles(3);
  measure_in_space(graph, {{0, 0, 0}, {0, 0, 3}, {4, 0, 0}});
  CHECK(graph.triangles[0].area_m2 == Approx(6.0));
  CHECK(graph.triangles[0].perimeter_squared_m2 == Approx(144.0));
}

TEST_CASE("Li2020 Eq. (3) in space recovers a rigid motion, by a proper rotation") {
  RandomStream random(13, "space_star_pose");
  for (int k = 0; k < 50; ++k) {
    const Pose3 T = any_motion(random);
    StarVertices<3> local, map, mirrored;
    for (std::size_t j = 0; j < 6; ++j) {
      const double x = random.uniform(-8.0, 8.0);
      const double z = k % 2 == 0 ? 0.0 : random.uniform(-2.0, 2.0);  // flat stars, too
      local[j] = {x, random.uniform(-8.0, 8.0), z};
      map[j] = T * local[j];
      mirrored[j] = Eigen::Vector3d(-map[j].x(), map[j].y(), map[j].z());
    }
    const SpaceStarPose pose = star_pose(local, map);
    CHECK((pose.T_map_local.matrix() - T.matrix()).norm() < 1e-9);
    CHECK(pose.cost_m < 1e-9);
    CHECK(star_pose(local, mirrored).T_map_local.linear().determinant() == Approx(1.0));
  }
}

TEST_CASE("Li2020 Eq. (4) in space chooses the pose of least distances, heights among them") {
  PoseCandidateIn<3> off;
  off.local_m.fill({0, 0, 0});
  off.map_m.fill({0, 0, 0});
  off.map_m[5] = {2, 3, 6};
  CHECK(mean_residual_m(off, Pose3::Identity()) == Approx(7.0 / 6.0));
  CHECK(largest_residual_m(off, Pose3::Identity()) == Approx(7.0));
  // Three poses that differ in height alone: the middle one is nearest to all.
  std::vector<PoseCandidateIn<3>> candidates(3, off);
  const double heights_m[] = {-3.0, 1.0, 2.0};
  for (std::size_t k = 0; k < 3; ++k) {
    candidates[k].map_m.fill({0, 0, heights_m[k]});
    candidates[k].T_map_local.translation().z() = heights_m[k];
  }
  const SelectionIn<3> selection = select_candidate(candidates);
  CHECK(selection.chosen == 1);
  CHECK(selection.T_map_local.translation().z() == 1.0);
  CHECK(selection.cost_m == Approx(6.0 * (4.0 + 0.0 + 1.0)));
}
