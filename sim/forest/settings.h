#pragma once

#include <string>

#include "sim/forest/crown.h"
#include "sim/forest/spacing/registry.h"
#include "sim/forest/terrain.h"
#include "sim/forest/trees.h"
#include "sim/forest/undergrowth.h"

namespace honka::sim {

struct ForestSettings {
  double width_m = 200.0;
  double length_m = 300.0;
  double margin_m = 0.0;
  double density_per_ha = 367.0;
  double corridor_half_width_m = 2.25;
  std::string stem_map;  ///< path; read by the caller
  SpacingSettings spacing;
  TreeSettings trees;
  CrownSettings crown;
  UndergrowthSettings undergrowth;
  TerrainSettings terrain;
};
void describe(SettingsVisitor& v, ForestSettings& s);

/// UserError when settings contradict one another.
void check(const ForestSettings& settings);

}  // namespace honka::sim
