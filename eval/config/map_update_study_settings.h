#pragma once

#include <cstdint>
#include <vector>

#include "algo/localize/map_update.h"
#include "algo/types/settings.h"
#include "sim/sighting/settings.h"

namespace honka::eval {

/// A drive through a stand that was thinned since its map was made; keys `map_update.*`.
struct MapUpdateStudySettings {
  std::vector<double> thinned_to_per_ha = {257.0, 156.0};
  double strip_road_spacing_m = 20.0;
  std::int64_t passes = 2;
  double view_every_m = 2.0;
  std::int64_t update_every = 25;
  sim::SightingSettings list;
  MapUpdateSettings updater;
};
void describe(SettingsVisitor& v, MapUpdateStudySettings& s);

}  // namespace honka::eval
