#include "eval/run/localize/source_map.h"

#include <fmt/format.h>

#include "algo/types/user_error.h"
#include "sim/forest/inventory.h"

namespace honka::eval {

bool lists_trees(std::string_view map_source) {
  return map_source == "inventory" || map_source == "airborne";
}

StemMap source_map(const sim::Stand& stand, const Scenario& scenario, std::uint64_t seed) {
  const MapSettings& map = scenario.map;
  if (map.source == "inventory") return sim::inventory_map(stand, map.sources.inventory, seed);
  if (map.source == "airborne") return sim::airborne_map(stand, map.sources.airborne, seed);
  throw UserError(
      fmt::format("map.source = \"{}\" is a run; this experiment takes inventory or "
                  "airborne",
                  map.source));
}

std::vector<Eigen::Vector2d> places_of(const StemMap& stems) {
  std::vector<Eigen::Vector2d> places_m;
  for (const Stem& stem : stems) places_m.push_back(stem.position_m);
  return places_m;
}

TrunkMap listed_trunk_map(const Scenario& scenario, const sim::Stand& stand,
                          const StemSettings& settings, std::uint64_t seed) {
  TrunkMap map;
  map.source = scenario.map.source;
  map.repaired = settings.height_band;
  for (const Stem& listed : source_map(stand, scenario, seed)) {
    ObservedStem stem;
    stem.position_m = listed.position_m;
    stem.dbh_m = listed.dbh_m;
    stem.z_m = listed.z_m.value_or(0.0);
    map.stems.push_back(stem);
  }
  map.graph = build_delaunay(map.positions_m());
  return map;
}

}  // namespace honka::eval
