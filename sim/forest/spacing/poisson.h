#pragma once

#include "algo/types/settings.h"
#include "sim/forest/spacing/domain.h"

namespace honka::sim {

/// Complete spatial randomness with the asked number of stems (a binomial process).
struct Poisson {
  static constexpr std::string_view kName = "poisson";

  [[nodiscard]] Points place(const SpacingDomain& domain, RandomStream& stream) const;
};
void describe(SettingsVisitor& v, Poisson& s);

}  // namespace honka::sim
