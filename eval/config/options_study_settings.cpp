#include "eval/config/options_study_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, OptionsStudySettings& s) {
  v.field({"queries", "", "places asked of each option, a stand", "choice"}, s.queries, {1, 1e6});
  v.field({"border_m", "m", "between the edge of the site and a place", "choice: a sensor's reach"},
          s.border_m, {0, 1000});
  v.field({"gnss_sigma_m", "m", "s.d. of x and of y of a position; its prior's radius is 3 of them",
           "Li2020 1: metres below a canopy"},
          s.gnss_sigma_m, {0.01, 1000});
  v.field(
      {"prior_radii_m", "m", "priors about the truth, displaced by half their radius", "choice"},
      s.prior_radii_m, {0.1, 1e5});
  v.field({"local_radii_m", "m", "of li2020.local_radius_m", "choice"}, s.local_radii_m,
          {0.1, 1e4});
  v.field({"submap_sizes_m", "m", "of li2020.submap_size_m", "choice"}, s.submap_sizes_m, {1, 1e6});
  v.field(
      {"slopes_deg", "deg", "plane slopes that the stand lies on, for stars in space", "choice"},
      s.slopes_deg, {0, 60});
  v.field({"height_noise_m", "m", "s.d. of a listed foot along the sensor's z, on slopes",
           "choice: ground found beside a stem, and its roots"},
          s.height_noise_m, {0, 10});
  v.group("list", [&] { describe(v, s.list); });
}

}  // namespace honka::eval
