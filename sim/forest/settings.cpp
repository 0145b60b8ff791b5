#include "sim/forest/settings.h"

#include <cmath>

#include "algo/types/user_error.h"

namespace honka::sim {

void describe(SettingsVisitor& v, ForestSettings& s) {
  v.field({"width_m", "m", "site along x, from 0", "Li2020: 200 m × 300 m"}, s.width_m,
          {5.0, 20000.0});
  v.field({"length_m", "m", "site along y, from 0", "Li2020: 200 m × 300 m"}, s.length_m,
          {5.0, 20000.0});
  v.field({"margin_m", "m", "forest of the same kind beyond the site on every side",
           "choice: none, so that the stand holds the paper's number of trees"},
          s.margin_m, {0.0, 1000.0});
  v.field({"density_per_ha", "1/ha", "stems per hectare of the site, roads included",
           "Li2020: about 2,200 trees on 6 ha"},
          s.density_per_ha, {1.0, 20000.0});
  v.field({"corridor_half_width_m", "m", "no stems nearer to the line a machine drives",
           "strip roads are 4 to 4.5 m wide"},
          s.corridor_half_width_m, {0.0, 50.0});
  v.field(
      {"stem_map", "", "CSV of a measured stand to put at the centre; empty for none", "choice"},
      s.stem_map, Choices{});
  v.group("spacing", [&] { describe(v, s.spacing); });
  v.group("trees", [&] { describe(v, s.trees); });
  v.group("crown", [&] { describe(v, s.crown); });
  v.group("undergrowth", [&] { describe(v, s.undergrowth); });
  v.group("terrain", [&] { describe(v, s.terrain); });
}

void check(const ForestSettings& settings) {
  const auto require = [](bool good, const char* line) {
    if (!good) throw UserError(line);
  };
  require(settings.width_m > 0.0 && settings.length_m > 0.0 && settings.margin_m >= 0.0,
          "forest: width_m and length_m must be positive and margin_m not negative");
  require(settings.density_per_ha > 0.0 && std::isfinite(settings.density_per_ha),
          "forest.density_per_ha must be positive");
  require(settings.trees.crown_base_low <= settings.trees.crown_base_high,
          "forest.trees: crown_base_low must not exceed crown_base_high");
  require(settings.crown.branches_per_whorl_low <= settings.crown.branches_per_whorl_high,
          "forest.crown: branches_per_whorl_low must not exceed branches_per_whorl_high");
  const double area_ha = 1e-4 * (settings.width_m + 2 * settings.margin_m) *
                         (settings.length_m + 2 * settings.margin_m);
  require(area_ha * settings.density_per_ha < 5e6,
          "forest: more than five million trees; lower density_per_ha, width_m or length_m");
}

}  // namespace honka::sim
