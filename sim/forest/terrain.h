#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "algo/types/settings.h"
#include "sim/world/heightfield.h"

namespace honka::sim {

struct TerrainSettings {
  double relief_m = 8.0;
  double relief_wavelength_m = 180.0;
  double slope_deg = 0.0;
  double slope_direction_deg = 90.0;
  double micro_relief_m = 0.05;
  double micro_wavelength_m = 4.0;
  double cell_m = 1.0;
  double border_m = 30.0;
};
void describe(SettingsVisitor& v, TerrainSettings& s);

/// Ground over the site and a border around it: rolling hills scaled to the asked relief inside
/// `extent_m`, a plane with the asked slope, and micro-relief. World frame, metres.
[[nodiscard]] Heightfield make_terrain(const TerrainSettings& settings,
                                       const Eigen::AlignedBox2d& extent_m, double margin_m,
                                       std::uint64_t seed);

}  // namespace honka::sim
