#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <set>

#include "sim/world/heightfield.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

/// z = 2 x − y on 4 × 3 nodes of 0.5 m from (10, 20).
Heightfield plane() {
  std::vector<double> heights;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 4; ++x) heights.push_back(2.0 * (10 + 0.5 * x) - (20 + 0.5 * y));
  }
  return {{10, 20}, 0.5, 4, 3, heights};
}

}  // namespace

TEST_CASE("a plane is met exactly, between nodes too") {
  const Heightfield ground = plane();
  CHECK(ground.height_m({10, 20}) == Approx(0.0).margin(1e-12));
  CHECK(ground.height_m({10.7, 20.3}) == Approx(1.1));
  CHECK(ground.height_m({11.5, 21.0}) == Approx(2.0));
  CHECK(ground.relief_m() == Approx(4.0));
  CHECK(ground.normal({10.7, 20.5}).isApprox(Eigen::Vector3d(-2, 1, 1).normalized()));
}

TEST_CASE("outside its border the ground keeps the border's height") {
  const Heightfield ground = plane();
  CHECK(ground.height_m({0, 20}) == Approx(ground.height_m({10, 20})).margin(1e-12));
  CHECK(ground.height_m({99, 99}) == Approx(ground.height_m({11.5, 21.0})));
}

TEST_CASE("no nodes are flat ground at 0") {
  CHECK(Heightfield().height_m({3, 4}) == 0.0);
  CHECK(Heightfield().relief_m() == 0.0);
}

TEST_CASE("the mesh covers the grid with triangles that look up") {
  const TriangleMesh mesh = plane().mesh();
  CHECK(mesh.vertices_m.size() == 12);
  REQUIRE(mesh.triangles.size() == 12);
  CHECK(mesh.label == Label{-1, Part::kGround});
  float area = 0.0F;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.vertices_m[t[0]];
    const Eigen::Vector3f n = (mesh.vertices_m[t[1]] - a).cross(mesh.vertices_m[t[2]] - a);
    CHECK(n.z() > 0.0F);
    area += 0.5F * n.z();
  }
  CHECK(area == Approx(1.5));  // of the ground plan
}

TEST_CASE("every part has a name of its own and a reflectivity") {
  std::set<std::string_view> names;
  for (int i = 0; i < kPartCount; ++i) {
    CHECK(names.insert(part_name(static_cast<Part>(i))).second);
    const double percent = World{}.reflectivity_percent[static_cast<std::size_t>(i)];
    CHECK((i == 0 || (percent > 0.0 && percent <= 100.0)));
  }
  CHECK(part_name(Part::kLog) == "log");
}
