#include <catch2/catch.hpp>
#include <set>

#include "algo/types/user_error.h"
#include "sim/forest/forest.h"
#include "sim/forest/spatial_statistics.h"

using namespace honka::sim;

namespace {

ForestSettings before() {
  ForestSettings settings;
  settings.width_m = 120.0;
  settings.length_m = 100.0;
  settings.density_per_ha = 700.0;
  return settings;
}

double mean_dbh_m(const Stand& stand) {
  double sum = 0.0;
  for (const Tree& tree : stand.trees) sum += tree.dbh_m;
  return sum / static_cast<double>(stand.trees.size());
}

}  // namespace

TEST_CASE("thinning reaches its density and leaves a stump for each tree") {
  const Stand stand = make_stand(before(), {}, 1);
  const Stand thinned = thin(stand, {}, 1);
  CHECK(thinned.trees.size() == 187);  // 156/ha on 1.2 ha
  CHECK(thinned.stumps.size() - stand.stumps.size() == stand.trees.size() - 187);
  std::set<std::int32_t> ids;
  for (const Tree& tree : thinned.trees) {
    CHECK(ids.insert(tree.id).second);
    CHECK(tree.base_m == stand.trees[static_cast<std::size_t>(tree.id)].base_m);
  }
  for (std::size_t i = stand.stumps.size(); i < thinned.stumps.size(); ++i) {
    CHECK(ids.insert(thinned.stumps[i].tree_id).second);
  }
  CHECK(ids.size() == stand.trees.size());
}

TEST_CASE("strip roads are open every 20 m") {
  const Stand thinned = thin(make_stand(before(), {}, 2), {}, 2);
  const double middle = thinned.extent_m.center().x();
  for (const Tree& tree : thinned.trees) {
    CHECK(std::abs(std::remainder(tree.base_m.x() - middle, 20.0)) >= 2.25);
  }
}

TEST_CASE("small and crowded trees fall first") {
  const Stand stand = make_stand(before(), {}, 3);
  ThinningSettings settings;
  settings.strip_road_width_m = 0.0;
  settings.target_density_per_ha = 350.0;
  const Stand thinned = thin(stand, settings, 3);
  REQUIRE(thinned.trees.size() == 420);
  CHECK(mean_dbh_m(thinned) > 1.05 * mean_dbh_m(stand));
  std::vector<Eigen::Vector2d> places, left;
  for (const Tree& tree : stand.trees) places.push_back(tree.base_m.head<2>());
  for (const Tree& tree : thinned.trees) left.push_back(tree.base_m.head<2>());
  CHECK(clark_evans(left, stand.extent_m) > clark_evans(places, stand.extent_m) + 0.1);
}

TEST_CASE("a stand sparser than the target loses its strip roads only") {
  const Stand stand = make_stand(before(), {}, 4);
  ThinningSettings settings;
  settings.target_density_per_ha = 5000.0;
  const Stand thinned = thin(stand, settings, 4);
  std::size_t on_road = 0;
  for (const Tree& tree : stand.trees) {
    on_road += std::abs(std::remainder(tree.base_m.x() - 60.0, 20.0)) < 2.25 ? 1 : 0;
  }
  CHECK(thinned.trees.size() == stand.trees.size() - on_road);
  settings.strip_road_width_m = 0.0;
  CHECK(thin(stand, settings, 4).trees.size() == stand.trees.size());
}

TEST_CASE("thinning has the same digits for a seed and refuses roads without a stand") {
  const Stand stand = make_stand(before(), {}, 5);
  const auto ids = [&](std::uint64_t seed) {
    std::vector<std::int32_t> standing;
    for (const Tree& tree : thin(stand, {}, seed).trees) standing.push_back(tree.id);
    return standing;
  };
  CHECK(ids(1) == ids(1));
  CHECK(ids(1) != ids(2));
  ThinningSettings settings;
  settings.strip_road_width_m = 20.0;
  CHECK_THROWS_AS(thin(stand, settings, 1), honka::UserError);
  CHECK(thin(Stand{stand.extent_m, stand.terrain, {}, {}, {}, {}, {}, {}}, {}, 1).trees.empty());
}
