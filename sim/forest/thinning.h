#pragma once

#include <cstdint>

#include "algo/types/settings.h"
#include "sim/forest/stand.h"

namespace honka::sim {

struct ThinningSettings {
  double target_density_per_ha = 156.0;
  double strip_road_spacing_m = 20.0;
  double strip_road_width_m = 4.5;
  double strip_road_direction_deg = 90.0;
  double strip_road_offset_m = 0.0;
  double judgement_sd = 0.1;
  double stump_height_m = 0.2;
};
void describe(SettingsVisitor& v, ThinningSettings& s);

/// The stand after a thinning: strip roads are cut, then the smallest and most crowded trees fall
/// until the target density is left. Trees keep their ids; stumps remain. A stand that is sparser
/// than the target loses its strip roads only.
[[nodiscard]] Stand thin(const Stand& stand, const ThinningSettings& settings, std::uint64_t seed);

}  // namespace honka::sim
