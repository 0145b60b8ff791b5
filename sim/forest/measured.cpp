#include "sim/forest/measured.h"

#include <string>

#include "algo/types/user_error.h"

namespace honka::sim {
namespace {

void check(const StemMap& stems) {
  if (stems.size() < 3) {
    throw UserError("forest.stem_map: " + std::to_string(stems.size()) +
                    " stems are too few for a stand; give at least 3");
  }
  for (std::size_t i = 0; i < stems.size(); ++i) {
    const Stem& stem = stems[i];
    const bool good = stem.position_m.allFinite() &&
                      (!stem.dbh_m || (*stem.dbh_m > 0.0 && *stem.dbh_m < 5.0)) &&
                      (!stem.height_m || (*stem.height_m > 1.3 && *stem.height_m < 150.0));
    if (!good) {
      throw UserError("forest.stem_map: stem " + std::to_string(i + 1) +
                      " has a position, DBH (0 to 5 m) or height (1.3 to 150 m) that cannot be; "
                      "mend or remove its line");
    }
  }
}

}  // namespace

MeasuredStand centred(const StemMap& stems, const Eigen::AlignedBox2d& site_m) {
  check(stems);
  Eigen::AlignedBox2d box_m;
  for (const Stem& stem : stems) box_m.extend(stem.position_m);
  const Eigen::Vector2d gap_m = box_m.sizes() / static_cast<double>(stems.size() - 1);
  if (gap_m.minCoeff() <= 0.0) {
    throw UserError("forest.stem_map: the stems stand on one line; a stand needs an area");
  }
  const Eigen::AlignedBox2d window_m(box_m.min() - gap_m, box_m.max() + gap_m);
  const Eigen::Vector2d shift_m = site_m.center() - window_m.center();

  MeasuredStand measured;
  measured.window_m = window_m.translated(shift_m);
  if (!site_m.contains(measured.window_m)) {
    throw UserError(
        "forest.stem_map: the measured stand is larger than the site; raise "
        "forest.width_m and forest.length_m");
  }
  measured.density_per_ha = 1e4 * static_cast<double>(stems.size()) / window_m.sizes().prod();
  measured.stems = stems;
  for (Stem& stem : measured.stems) stem.position_m += shift_m;
  return measured;
}

}  // namespace honka::sim
