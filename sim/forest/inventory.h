#pragma once

#include <cstdint>

#include "algo/types/settings.h"
#include "algo/types/stem.h"
#include "sim/forest/stand.h"

namespace honka::sim {

/// A stem map measured on the ground, tree by tree.
struct InventorySettings {
  double least_dbh_m = 0.07;
  double position_error_m = 0.10;
  double missed_share = 0.0;
};
void describe(SettingsVisitor& v, InventorySettings& s);

/// Tree tops found from the air.
struct AirborneSettings {
  double position_error_m = 0.5;
  double asymmetry_share = 0.2;
  double crown_radius_share = 0.1;
  double overtopped_by_m = 1.0;
  double least_height_m = 5.0;
};
void describe(SettingsVisitor& v, AirborneSettings& s);

/// The stems of a stand as a field crew lists them: all above a diameter, at breast height (1.3 m),
/// each with an error of its own. In the order of the trees; the digits depend on (tree, seed).
[[nodiscard]] StemMap inventory_map(const Stand& stand, const InventorySettings& settings,
                                    std::uint64_t seed);

/// The tree tops of a stand as an airborne scan shows them. A top lies off its stem by the lean
/// over the tree's height, by the asymmetry of the crown (s.d. a share of the crown's radius), and
/// by the error of the scan. A tree whose top lies within the crown radius of a neighbour taller
/// by `overtopped_by_m` is not seen, nor one below `least_height_m`. z is the ground below the top.
[[nodiscard]] StemMap airborne_map(const Stand& stand, const AirborneSettings& settings,
                                   std::uint64_t seed);

}  // namespace honka::sim
