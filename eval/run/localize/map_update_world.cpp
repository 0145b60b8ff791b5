#include "eval/run/localize/map_update_world.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/trial_world.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"

namespace honka::eval {
namespace {

/// A thinning whose strip roads are those that are driven: along the longer side, centred.
sim::ThinningSettings thinning_of(const Scenario& scenario, double thinned_to_per_ha,
                                  std::size_t roads) {
  sim::ThinningSettings thinning;
  thinning.target_density_per_ha = thinned_to_per_ha;
  thinning.strip_road_spacing_m = scenario.map_update.strip_road_spacing_m;
  thinning.strip_road_direction_deg =
      scenario.forest.length_m >= scenario.forest.width_m ? 90.0 : 0.0;
  thinning.strip_road_offset_m = roads % 2 == 0 ? 0.5 * thinning.strip_road_spacing_m : 0.0;
  return thinning;
}

/// The lists of one road, half a step from its ends: none is made on the border itself.
void drive_road(MapUpdateWorld& world, const sim::Polyline& road, std::int64_t number,
                double every_m) {
  const Eigen::Vector2d ahead = (road.back() - road.front()).normalized();
  const double length = sim::length_m(road);
  for (double at = 0.5 * every_m; at < length; at += every_m) {
    world.T_world_sensor.push_back({sim::point_at(road, at), std::atan2(ahead.y(), ahead.x())});
    world.road.push_back(number);
  }
}

/// One road after the other, to and fro; every further pass comes back along the one before it.
void drive_roads(MapUpdateWorld& world, const std::vector<sim::Polyline>& roads,
                 const MapUpdateStudySettings& settings) {
  const auto count = static_cast<std::int64_t>(roads.size());
  for (std::int64_t pass = 0; pass < settings.passes; ++pass) {
    for (std::int64_t i = 0; i < count; ++i) {
      const std::int64_t number = pass % 2 == 0 ? i : count - 1 - i;
      sim::Polyline road = roads[static_cast<std::size_t>(number)];
      if ((number + pass) % 2 == 1) std::reverse(road.begin(), road.end());
      drive_road(world, road, number, settings.view_every_m);
    }
  }
}

/// Every tree of the stand before the thinning, with which of them still stand.
void fill_forest(sim::MappedForest& forest, const sim::Stand& before, const sim::Stand& after) {
  forest.box_m = before.extent_m;
  forest.trees_m = places_of(true_stems(before));
  std::unordered_set<std::int32_t> standing;
  for (const sim::Tree& tree : after.trees) standing.insert(tree.id);
  for (const sim::Tree& tree : before.trees) {
    forest.standing.push_back(standing.count(tree.id) != 0 ? 1 : 0);
  }
  forest.in_map.assign(forest.trees_m.size(), 0);
  forest.near = std::make_unique<KdTree2>(forest.trees_m);
}

}  // namespace

double MapUpdateWorld::felled_share() const {
  const auto felled = std::count(forest.standing.begin(), forest.standing.end(), 0);
  return static_cast<double>(felled) /
         static_cast<double>(std::max<std::size_t>(1, forest.standing.size()));
}

MapUpdateWorld make_map_update_world(const Scenario& scenario, std::int64_t trial,
                                     double thinned_to_per_ha) {
  MapUpdateWorld world;
  world.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "map_update_trial",
                           {static_cast<std::uint64_t>(trial)});
  const sim::Stand before = sim::make_stand(scenario.forest, {}, world.seed);
  const auto roads = sim::strip_roads(before.extent_m, scenario.map_update.strip_road_spacing_m);
  const sim::Stand after =
      sim::thin(before, thinning_of(scenario, thinned_to_per_ha, roads.size()), world.seed);
  fill_forest(world.forest, before, after);
  world.old_map = source_map(before, scenario, world.seed);
  world.old_map_m = places_of(world.old_map);
  // Errors of a position belong to the tree, so that the two maps differ in their trees alone.
  sim::InventorySettings every_tree = scenario.map.sources.inventory;
  every_tree.least_dbh_m = 0.0;
  every_tree.missed_share = 0.0;
  world.new_map_m = places_of(sim::inventory_map(after, every_tree, world.seed));
  drive_roads(world, roads, scenario.map_update);
  return world;
}

std::vector<Eigen::Vector2d> list_at(const MapUpdateWorld& world, const Scenario& scenario,
                                     std::size_t k) {
  return sim::sight(world.forest, world.T_world_sensor[k], scenario.map_update.list, world.seed,
                    static_cast<std::uint64_t>(k))
      .stems_in_sensor_m;
}

}  // namespace honka::eval
