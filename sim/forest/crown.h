#pragma once

#include <cstdint>

#include "algo/types/settings.h"
#include "sim/forest/stand.h"

namespace honka::sim {

struct CrownSettings {
  bool branches = true;
  bool foliage = true;
  double whorl_spacing_m = 0.5;
  std::int64_t branches_per_whorl_low = 4;
  std::int64_t branches_per_whorl_high = 6;
  double crown_radius_share = 0.1;
  double foliage_share = 0.22;
  double dead_branches_per_m = 1.5;
  double dead_from_share = 0.35;
};
void describe(SettingsVisitor& v, CrownSettings& s);

/// Adds the branches (cones), the needles (ellipsoids) and the dead branches of a tree.
void add_crown(const CrownSettings& settings, const Tree& tree, std::uint64_t seed, World& world);

}  // namespace honka::sim
