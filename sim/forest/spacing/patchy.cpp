#include "sim/forest/spacing/patchy.h"

#include <cmath>

#include "algo/types/user_error.h"
#include "sim/forest/spacing/torus_grid.h"

namespace honka::sim {

void describe(SettingsVisitor& v, Patchy& s) {
  v.field({"patches_per_ha", "1/ha", "centres of patches", "choice"}, s.patches_per_ha,
          {0.1, 1000.0});
  v.field({"patch_sd_m", "m", "standard deviation of a patch along x and y", "choice"},
          s.patch_sd_m, {0.1, 100.0});
  v.field({"clustered_share", "", "share of stems that belong to a patch", "choice"},
          s.clustered_share, {0.0, 1.0});
  v.field({"core_m", "m", "least distance of two stems", "choice: stems do not touch"}, s.core_m,
          {0.01, 5.0});
}

Points Patchy::place(const SpacingDomain& domain, RandomStream& stream) const {
  constexpr int kTries = 20000;  // in a row without room
  const double area_ha = 1e-4 * domain.box_m.sizes().prod();
  const auto patches = std::max(1L, std::lround(patches_per_ha * area_ha));
  Points centres;
  for (long i = 0; i < patches; ++i) centres.push_back(domain.draw(stream));
  TorusGrid grid(domain.box_m, std::max(core_m, 0.3 * domain.spacing_m));
  for (const auto& fixed : domain.fixed_m) grid.add(fixed);

  Points placed;
  int tries = 0;
  while (static_cast<std::int64_t>(placed.size()) < domain.count) {
    if (++tries > kTries) {
      throw UserError(
          "forest.spacing.patchy: the patches have no room at this density; lower "
          "forest.density_per_ha or widen forest.spacing.patchy.patch_sd_m");
    }
    Eigen::Vector2d place_m = domain.draw(stream);
    if (stream.uniform() < clustered_share) {
      const double dx = stream.normal(0.0, patch_sd_m), dy = stream.normal(0.0, patch_sd_m);
      place_m = domain.wrapped(centres[stream.below(centres.size())] + Eigen::Vector2d(dx, dy));
    }
    bool room = domain.is_free(place_m);
    grid.near(place_m,
              [&](std::size_t, double distance2) { room = room && distance2 >= core_m * core_m; });
    if (!room) continue;
    tries = 0;
    grid.add(place_m);
    placed.push_back(place_m);
  }
  return placed;
}

}  // namespace honka::sim
