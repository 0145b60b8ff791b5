#include "eval/config/map_update_study_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, MapUpdateStudySettings& s) {
  v.field({"thinned_to_per_ha", "1/ha",
           "stems that the thinning between map and drive leaves; a study of its own each",
           "Li2020 2.1: 4.4 m to 8 m mean distance is 156/ha; choice: 30 % felled of 367/ha"},
          s.thinned_to_per_ha, {1, 20000});
  v.field({"strip_road_spacing_m", "m", "between the strip roads that are cut and driven",
           "Nordic thinning practice: every 20 m"},
          s.strip_road_spacing_m, {5, 500});
  v.field({"passes", "", "drives over all strip roads, each back along the one before", "choice"},
          s.passes, {1, 20});
  v.field({"view_every_m", "m", "way from one stem list to the next", "choice"}, s.view_every_m,
          {0.1, 1000});
  v.field({"update_every", "", "stem lists from one update of the map to the next", "choice"},
          s.update_every, {1, 1e6});
  v.group("list", [&] { describe(v, s.list); });
  v.group("updater", [&] { describe(v, s.updater); });
}

}  // namespace honka::eval
