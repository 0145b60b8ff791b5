// Stem maps from the ground and from the air, of stands with known answers.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/forest/forest.h"
#include "sim/forest/inventory.h"

using namespace honka;
using namespace honka::sim;

namespace {

Stand stand_of(const std::vector<Tree>& trees) {
  Stand stand;
  stand.terrain = Heightfield({-100.0, -100.0}, 200.0, 2, 2, {5.0, 5.0, 5.0, 5.0});
  stand.trees = trees;
  return stand;
}

Tree upright_tree(std::int32_t id, double x_m, double height_m, double dbh_m) {
  Tree tree;
  tree.id = id;
  tree.base_m = {x_m, 0.0, 5.0};
  tree.height_m = height_m;
  tree.dbh_m = dbh_m;
  return tree;
}

Stand grown_stand() {
  ForestSettings settings;
  settings.width_m = 150.0;
  settings.length_m = 150.0;
  settings.density_per_ha = 600.0;
  return make_stand(settings, {}, 3);
}

}  // namespace

TEST_CASE("An inventory without error lists every stem above the limit at breast height") {
  Tree leaning = upright_tree(1, 10.0, 20.0, 0.2);
  leaning.lean = {0.1, 0.0};
  const Stand stand = stand_of({upright_tree(0, 0.0, 5.0, 0.06), leaning});
  InventorySettings settings;
  settings.position_error_m = 0.0;
  const StemMap map = inventory_map(stand, settings, 1);
  REQUIRE(map.size() == 1);
  CHECK(map[0].position_m.x() == Approx(10.13));
  CHECK(map[0].z_m.value() == Approx(5.0));
  CHECK(map[0].dbh_m.value() == Approx(0.2));
}

TEST_CASE("The errors of an inventory have the stated spread and belong to the tree") {
  const Stand stand = grown_stand();
  InventorySettings settings;
  settings.least_dbh_m = 0.0;
  settings.position_error_m = 0.3;
  const StemMap map = inventory_map(stand, settings, 1);
  REQUIRE(map.size() == stand.trees.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < map.size(); ++i) {
    sum += (map[i].position_m - stem_centre_m(stand.trees[i], 1.3)).squaredNorm();
  }
  const double sd_m = std::sqrt(sum / (2.0 * static_cast<double>(map.size())));
  CHECK(sd_m == Approx(0.3).epsilon(0.1));
  Stand fewer = stand;
  fewer.trees.erase(fewer.trees.begin(), fewer.trees.begin() + 100);
  CHECK(inventory_map(fewer, settings, 1)[0] == map[100]);
  CHECK(inventory_map(stand, settings, 2)[0].position_m != map[0].position_m);
}

TEST_CASE("An inventory misses the stated share") {
  InventorySettings settings;
  settings.least_dbh_m = 0.0;
  settings.missed_share = 0.3;
  const Stand stand = grown_stand();
  const double listed = static_cast<double>(inventory_map(stand, settings, 1).size());
  CHECK(listed / static_cast<double>(stand.trees.size()) == Approx(0.7).margin(0.05));
}

TEST_CASE("From the air a top is displaced by the lean, and overtopped trees are not seen") {
  AirborneSettings settings;
  settings.position_error_m = 0.0;
  settings.asymmetry_share = 0.0;
  Tree leaning = upright_tree(0, 0.0, 20.0, 0.2);
  leaning.lean = {0.05, 0.0};  // top at x = 1, crown radius 2 m
  const Stand stand = stand_of({leaning, upright_tree(1, 2.9, 15.0, 0.1),
                                upright_tree(2, 3.1, 15.0, 0.1), upright_tree(3, 30.0, 4.0, 0.1)});
  const StemMap map = airborne_map(stand, settings, 1);
  REQUIRE(map.size() == 2);
  CHECK(map[0].position_m.x() == Approx(1.0));
  CHECK(map[1].position_m.x() == Approx(3.1));
  CHECK(map[0].z_m.value() == Approx(5.0));
  CHECK_FALSE(map[0].dbh_m);
}

TEST_CASE("From the air the dominant trees of a stand are seen, and tops lie off their stems") {
  const Stand stand = grown_stand();
  const StemMap tops = airborne_map(stand, {}, 1);
  const double seen = static_cast<double>(tops.size()) / static_cast<double>(stand.trees.size());
  CHECK(seen > 0.5);
  CHECK(seen < 0.98);
  double tops_m = 0.0, trees_m = 0.0;
  for (const Stem& top : tops) tops_m += top.height_m.value();
  for (const Tree& tree : stand.trees) trees_m += tree.height_m;
  CHECK(tops_m / static_cast<double>(tops.size()) >
        trees_m / static_cast<double>(stand.trees.size()));
  CHECK(airborne_map(stand, {}, 1) == tops);
  CHECK(airborne_map(stand_of({}), {}, 1).empty());
}
