#pragma once

#include "algo/types/settings.h"
#include "sim/forest/spacing/domain.h"

namespace honka::sim {

/// A clustered stand: a share of the stems gathers about random centres (a Thomas process with a
/// fixed number of stems), the others stand anywhere.
struct Patchy {
  static constexpr std::string_view kName = "patchy";
  double patches_per_ha = 15.0;
  double patch_sd_m = 3.5;
  double clustered_share = 0.75;
  double core_m = 0.5;

  /// UserError when the patches have no room for their stems.
  [[nodiscard]] Points place(const SpacingDomain& domain, RandomStream& stream) const;
};
void describe(SettingsVisitor& v, Patchy& s);

}  // namespace honka::sim
