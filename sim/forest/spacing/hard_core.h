#pragma once

#include "algo/types/settings.h"
#include "sim/forest/spacing/domain.h"

namespace honka::sim {

/// Dart throwing: uniform places, each kept when no stem stands nearer than a hard core.
struct HardCore {
  static constexpr std::string_view kName = "hard_core";
  double core = 0.33;

  /// UserError when the darts no longer find room.
  [[nodiscard]] Points place(const SpacingDomain& domain, RandomStream& stream) const;
};
void describe(SettingsVisitor& v, HardCore& s);

}  // namespace honka::sim
