#include "sim/forest/spacing/poisson.h"

namespace honka::sim {

void describe(SettingsVisitor&, Poisson&) {}

Points Poisson::place(const SpacingDomain& domain, RandomStream& stream) const {
  Points placed;
  for (std::int64_t i = 0; i < domain.count; ++i) placed.push_back(domain.draw(stream));
  return placed;
}

}  // namespace honka::sim
