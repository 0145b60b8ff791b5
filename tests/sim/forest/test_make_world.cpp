#include <catch2/catch.hpp>
#include <map>

#include "sim/forest/forest.h"

using namespace honka::sim;

namespace {

ForestSettings plot() {
  ForestSettings settings;
  settings.width_m = 60.0;
  settings.length_m = 50.0;
  return settings;
}

std::size_t count(const World& world, Part part) {
  std::size_t n = 0;
  for (const Cone& cone : world.cones) n += cone.label.part == part ? 1 : 0;
  for (const Ellipsoid& ellipsoid : world.ellipsoids) n += ellipsoid.label.part == part ? 1 : 0;
  return n;
}

/// The cones of each tree's stem, from the ground up.
std::map<std::int32_t, std::vector<Cone>> stems_of(const World& world) {
  std::map<std::int32_t, std::vector<Cone>> stems;
  for (const Cone& cone : world.cones) {
    if (cone.label.part == Part::kStem) stems[cone.label.owner].push_back(cone);
  }
  return stems;
}

}  // namespace

TEST_CASE("every stem is one chain of cones from below the ground to the top") {
  const Stand stand = make_stand(plot(), {}, 1);
  const auto stems = stems_of(make_world(stand, plot(), 1));
  REQUIRE(stems.size() == stand.trees.size());
  for (const Tree& tree : stand.trees) {
    const auto& chain = stems.at(tree.id);
    CHECK(chain.size() == 10);
    CHECK(chain.front().a_m.z() < tree.base_m.z() - 0.3);
    CHECK(chain.back().b_m.z() == Approx(tree.base_m.z() + tree.height_m));
    CHECK(chain.back().radius_b_m == 0.0);
    for (std::size_t i = 1; i < chain.size(); ++i) {
      CHECK(chain[i].a_m == chain[i - 1].b_m);
      CHECK(chain[i].radius_a_m == chain[i - 1].radius_b_m);
    }
  }
}

TEST_CASE("the chain keeps to the taper and the lean within 3 mm where a lidar looks") {
  const Stand stand = make_stand(plot(), {}, 2);
  const auto stems = stems_of(make_world(stand, plot(), 1));
  double worst_m = 0.0;
  for (const Tree& tree : stand.trees) {
    for (const Cone& cone : stems.at(tree.id)) {
      for (double share = 0.05; share < 1.0; share += 0.1) {
        const Eigen::Vector3d axis = cone.a_m + share * (cone.b_m - cone.a_m);
        const double height_m = axis.z() - tree.base_m.z();
        if (height_m < 0.5 || height_m > 0.7 * tree.height_m) continue;
        const double radius_m = cone.radius_a_m + share * (cone.radius_b_m - cone.radius_a_m);
        worst_m = std::max(worst_m, std::abs(radius_m - stem_radius_m(tree, height_m)));
        CHECK((axis.head<2>() - stem_centre_m(tree, height_m)).norm() < 1e-9);
      }
    }
  }
  CHECK(worst_m < 0.003);
}

TEST_CASE("crowns hang on their trees: owners, heights, about 60 live branches") {
  const Stand stand = make_stand(plot(), {}, 1);
  const World world = make_world(stand, plot(), 1);
  const auto trees = static_cast<double>(stand.trees.size());
  CHECK(static_cast<double>(count(world, Part::kBranch)) / trees == Approx(65).margin(10));
  CHECK(static_cast<double>(count(world, Part::kDeadBranch)) / trees == Approx(9).margin(3));
  for (const Cone& cone : world.cones) {
    if (cone.label.part != Part::kBranch && cone.label.part != Part::kDeadBranch) continue;
    const Tree& tree = stand.trees[static_cast<std::size_t>(cone.label.owner)];
    const double height_m = cone.a_m.z() - tree.base_m.z();
    CHECK((cone.a_m.head<2>() - stem_centre_m(tree, height_m)).norm() < 1e-9);
    CHECK(cone.radius_a_m < stem_radius_m(tree, 0.0));
    if (cone.label.part == Part::kBranch) {
      CHECK(height_m > tree.crown_base_m - 0.3);
    } else {
      CHECK(height_m <= tree.crown_base_m);
    }
  }
}

TEST_CASE("switches take crowns away") {
  const Stand stand = make_stand(plot(), {}, 1);
  ForestSettings bare = plot();
  bare.crown.branches = false;
  CHECK(count(make_world(stand, bare, 1), Part::kBranch) == 0);
  CHECK(count(make_world(stand, bare, 1), Part::kFoliage) == 0);
  ForestSettings winter = plot();
  winter.crown.foliage = false;
  CHECK(count(make_world(stand, winter, 1), Part::kBranch) > 0);
  CHECK(count(make_world(stand, winter, 1), Part::kFoliage) == 0);
}

TEST_CASE("what lies on the ground is in the world, and every number is finite") {
  const std::vector<Polyline> road = {{{0, 25}, {60, 25}}};
  ForestSettings settings = plot();
  settings.undergrowth.log_piles_per_100_m = 20.0;
  const Stand stand = thin(make_stand(settings, road, 3), {}, 3);
  const World world = make_world(stand, settings, 3);
  CHECK(count(world, Part::kUndergrowth) == 5 * stand.bushes.size() + 4 * stand.saplings.size());
  CHECK(count(world, Part::kRock) == stand.rocks.size());
  CHECK(count(world, Part::kStump) == 2 * stand.stumps.size());
  CHECK(count(world, Part::kLog) == 3 * stand.logs.size());
  REQUIRE(stand.logs.size() > 3);
  for (const Cone& cone : world.cones) {
    CHECK(cone.a_m.allFinite());
    CHECK(cone.b_m.allFinite());
    CHECK((cone.b_m - cone.a_m).norm() > 0.0);
    CHECK(cone.radius_a_m > 0.0);
  }
  for (const Ellipsoid& ellipsoid : world.ellipsoids) {
    CHECK(ellipsoid.centre_m.allFinite());
    CHECK(ellipsoid.half_axes_m.minCoeff() > 0.0);
  }
}

TEST_CASE("a tree's crown belongs to the tree, not to its place in the list") {
  Stand stand = make_stand(plot(), {}, 1);
  const World all = make_world(stand, plot(), 1);
  stand.trees.erase(stand.trees.begin(), stand.trees.begin() + 10);
  const World fewer = make_world(stand, plot(), 1);
  const auto last_branch = [](const World& world) {
    Eigen::Vector3d tip = Eigen::Vector3d::Zero();
    for (const Cone& cone : world.cones) {
      if (cone.label.part == Part::kBranch) tip = cone.b_m;
    }
    return tip;
  };
  CHECK(last_branch(all) == last_branch(fewer));
}
