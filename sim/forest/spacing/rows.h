#pragma once

#include "algo/types/settings.h"
#include "sim/forest/spacing/domain.h"

namespace honka::sim {

/// A planted stand: rows of a jittered lattice of which a share has survived.
struct Rows {
  static constexpr std::string_view kName = "rows";
  double row_ratio = 1.25;
  double jitter = 0.08;
  double survival = 0.8;
  double direction_deg = 0.0;

  /// UserError when the free ground has no room for the rows.
  [[nodiscard]] Points place(const SpacingDomain& domain, RandomStream& stream) const;
};
void describe(SettingsVisitor& v, Rows& s);

}  // namespace honka::sim
