#include "eval/run/trunk_map.h"

#include <fmt/format.h>

#include <chrono>

#include "algo/types/check.h"
#include "algo/types/user_error.h"
#include "eval/run/localize/timed_matcher.h"

namespace honka::eval {
namespace {

using Clock = std::chrono::steady_clock;

const TrunkMap& find_map(const std::vector<TrunkMap>& maps, const std::string& source,
                         bool is_repaired) {
  for (const TrunkMap& map : maps) {
    if (map.source == source && map.repaired == is_repaired) return map;
  }
  HONKA_CHECK(false, "no map of source " + source);
}

Variant make_variant(std::string name, const Scenario& scenario, const TrunkMap& map,
                     double tolerance_m2, StemSettings stems, const std::string& method = "") {
  LocalizeSettings settings = scenario.localize;
  settings.li2020.tolerance_m2 = tolerance_m2;
  if (!method.empty()) settings.method = method;
  Variant variant{std::move(name), settings.method, &map, tolerance_m2, std::move(stems), nullptr};
  try {
    variant.matcher = create_matcher(settings.method, map.positions_m(), settings);
  } catch (const UserError&) {
    // A map that cannot be matched in is a result of the trial: its rows say so.
  }
  return variant;
}

/// The other matchers on the stems of the default and of the repaired chain.
void add_other_methods(const Scenario& scenario, std::vector<Variant>& variants) {
  const std::size_t count = variants.size();
  for (const std::string& method : methods_of(scenario.variants.methods, scenario.localize)) {
    if (method == scenario.localize.method) continue;
    for (std::size_t i = 0; i < count; ++i) {
      if (variants[i].name != "default" && variants[i].name != "repaired") continue;
      const std::string suffix = variants[i].map->repaired ? "_repaired" : "";
      variants.push_back(make_variant(method + suffix, scenario, *variants[i].map,
                                      variants[i].tolerance_m2, variants[i].stems, method));
    }
  }
}

}  // namespace

std::vector<Eigen::Vector2d> TrunkMap::positions_m() const {
  std::vector<Eigen::Vector2d> positions;
  for (const ObservedStem& stem : stems) positions.push_back(stem.position_m);
  return positions;
}

TrunkMap make_trunk_map(std::string source, const LocalCloud& cloud_in_odom,
                        const StemSettings& settings, const Pose2& T_world_odom) {
  const auto start = Clock::now();
  TrunkMap map;
  map.source = std::move(source);
  map.repaired = settings.height_band;
  map.stems = extract_stems(cloud_in_odom, settings).stems;
  for (ObservedStem& stem : map.stems) stem.position_m = T_world_odom * stem.position_m;
  map.graph = build_delaunay(map.positions_m());
  map.extract_s = std::chrono::duration<double>(Clock::now() - start).count();
  return map;
}

StemSettings repaired(StemSettings settings, const std::string& centre) {
  settings.height_band = true;
  settings.centre = centre;
  return settings;
}

std::vector<Variant> make_variants(const Scenario& scenario, const std::vector<TrunkMap>& maps) {
  const double tolerance_m2 = scenario.localize.li2020.tolerance_m2;
  const TrunkMap& map = find_map(maps, scenario.map.source, false);
  std::vector<Variant> variants;
  variants.push_back(make_variant("default", scenario, map, tolerance_m2, scenario.stems));
  if (scenario.variants.same_run && scenario.map.source != "same_run") {
    variants.push_back(make_variant("same_run", scenario, find_map(maps, "same_run", false),
                                    tolerance_m2, scenario.stems));
  }
  for (const double other_m2 : scenario.variants.tolerances_m2) {
    if (other_m2 == tolerance_m2) continue;
    variants.push_back(make_variant(fmt::format("tolerance_{}", other_m2), scenario, map, other_m2,
                                    scenario.stems));
  }
  if (scenario.variants.repaired) {
    variants.push_back(make_variant("repaired", scenario, find_map(maps, scenario.map.source, true),
                                    tolerance_m2, repaired(scenario.stems, "bias_corrected")));
  }
  add_other_methods(scenario, variants);
  return variants;
}

}  // namespace honka::eval
