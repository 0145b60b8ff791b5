#pragma once

#include <cstdint>

#include "algo/types/settings.h"

namespace honka::sim {

/// How the stem list of a detector differs from the trees that stand around it.
struct SightingSettings {
  double range_m = 30.0;
  double field_of_view_deg = 210.0;
  std::int64_t most_stems = 0;
  double noise_m = 0.05;
  double radial_bias_m = 0.0;
  double missed_share = 0.0;
  double false_share = 0.0;
};
void describe(SettingsVisitor& v, SightingSettings& s);

/// How a stem map differs from the forest it was made of, and from the forest as it is now.
struct MappingSettings {
  std::int64_t stems = 2200;
  double noise_m = 0.0;
  double missed_share = 0.0;
  double felled_share = 0.0;
  double grown_share = 0.0;
};
void describe(SettingsVisitor& v, MappingSettings& s);

}  // namespace honka::sim
