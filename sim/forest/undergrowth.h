#pragma once

#include <cstdint>

#include "algo/types/settings.h"
#include "sim/forest/corridor_mask.h"
#include "sim/forest/stand.h"

namespace honka::sim {

struct UndergrowthSettings {
  double bushes_per_ha = 100.0;
  double bush_height_m = 0.9;
  double saplings_per_ha = 50.0;
  double sapling_height_m = 1.6;
  double rocks_per_ha = 60.0;
  double rock_radius_m = 0.35;
  double stumps_per_ha = 250.0;
  double stump_height_m = 0.2;
  double log_piles_per_100_m = 3.0;
};
void describe(SettingsVisitor& v, UndergrowthSettings& s);

/// Puts bushes, saplings, rocks and old stumps on the ground of `box_m` outside the corridors, and
/// piles of felled stems beside them. Needs `stand.terrain`.
void add_undergrowth(const UndergrowthSettings& settings, const Eigen::AlignedBox2d& box_m,
                     const std::vector<Polyline>& corridors, double corridor_half_width_m,
                     std::uint64_t seed, Stand& stand);

}  // namespace honka::sim
