#include <catch2/catch.hpp>

#include "algo/geometry/cell_index.h"
#include "algo/geometry/voxel_grid.h"
#include "algo/types/random.h"

using namespace honka;

TEST_CASE("one point a voxel: the first, or the mean") {
  const std::vector<Eigen::Vector3d> points = {
      {0.1, 0.1, 0.1}, {0.3, 0.1, 0.1}, {-0.1, 0.1, 0.1}, {0.9, 0.9, 0.9}, {1.0, 0.0, 0.0}};
  const auto first = thin(points, 1.0);
  REQUIRE(first.size() == 3);  // (0,0,0), (−1,0,0), (1,0,0)
  CHECK(first[0] == points[0]);
  CHECK(first[1] == points[2]);
  CHECK(first[2] == points[4]);
  const auto mean = thin(points, 1.0, VoxelGrid::Keep::kMean);
  CHECK((mean[0] - Eigen::Vector3d(1.3 / 3, 1.1 / 3, 1.1 / 3)).norm() < 1e-15);
}

TEST_CASE("thinning twice is thinning once, in a stream or at once") {
  RandomStream random(5, "voxels");
  std::vector<Eigen::Vector3d> points;
  VoxelGrid stream(0.025);
  std::size_t fresh = 0;
  for (int i = 0; i < 60000; ++i) {
    const double x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
    points.emplace_back(x, y, random.uniform(0.0, 0.1));
    fresh += stream.insert(points.back()) ? 1 : 0;
  }
  CHECK(fresh == stream.size());
  const auto once = thin(points, 0.025);
  CHECK(once == stream.points_m());
  CHECK(thin(once, 0.025) == once);
}

TEST_CASE("cells keep their members in order and find their neighbours") {
  const std::vector<Eigen::Vector2d> points = {{0.1, 0.1}, {1.1, 0.1}, {0.2, 0.3}, {0.1, 1.9}};
  const CellLattice<2> lattice(points, 1.0);
  std::vector<std::uint64_t> keys;
  for (const auto& p : points) keys.push_back(lattice.key(p));
  const CellIndex cells(keys);
  REQUIRE(cells.cell_count() == 3);
  REQUIRE(cells.members(0).size() == 2);
  CHECK(cells.members(0)[1] == 2);
  CHECK(cells.find(keys[0] + CellLattice<2>::step({1, 0})) == cells.cell_of(1));
  CHECK(cells.find(keys[1] + CellLattice<2>::step({-1, 1})) == cells.cell_of(3));
  CHECK_FALSE(cells.find(keys[0] + CellLattice<2>::step({-1, -1})).has_value());
}
