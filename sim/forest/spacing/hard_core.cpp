#include "sim/forest/spacing/hard_core.h"

#include "algo/types/user_error.h"
#include "sim/forest/spacing/torus_grid.h"

namespace honka::sim {

void describe(SettingsVisitor& v, HardCore& s) {
  v.field({"core", "s", "least distance of two stems, in units of s = 1 / √density",
           "mature Scots pine: 0.33 is the plain fallback of a soft core"},
          s.core, {0.0, 1.0});
}

Points HardCore::place(const SpacingDomain& domain, RandomStream& stream) const {
  constexpr int kTries = 2000;  // in a row without room: jammed
  const double core_m = core * domain.spacing_m;
  TorusGrid grid(domain.box_m, std::max(core_m, 0.1 * domain.spacing_m));
  for (const auto& fixed : domain.fixed_m) grid.add(fixed);
  Points placed;
  int tries = 0;
  while (static_cast<std::int64_t>(placed.size()) < domain.count) {
    const Eigen::Vector2d dart = domain.draw(stream);
    bool room = true;
    grid.near(dart,
              [&](std::size_t, double distance2) { room = room && distance2 >= core_m * core_m; });
    if (!room && ++tries == kTries) {
      throw UserError(
          "forest.spacing.hard_core: the stems do not fit at this density; lower "
          "forest.density_per_ha or forest.spacing.hard_core.core");
    }
    if (!room) continue;
    tries = 0;
    grid.add(dart);
    placed.push_back(dart);
  }
  return placed;
}

}  // namespace honka::sim
