#include "eval/config/tracking_study_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, TrackingStudySettings& s) {
  v.group("study", [&] {
    v.field({"frames", "", "key frames in a localization, a track for each number", "choice"},
            s.frames, {1, 100});
    v.field({"localize_every_m", "m", "way of the odometry from one localization to the next",
             "choice: every third key frame"},
            s.localize_every_m, {0, 1000});
    v.field({"second_length_m", "m",
             "drive after the sensor was carried off, in another place; 0: it never is", "choice"},
            s.second_length_m, {0, 5000});
    v.field({"unmapped_from_m", "m", "way of the first drive at which a hole of the map begins",
             "choice"},
            s.unmapped_from_m, {0, 5000});
    v.field({"unmapped_length_m", "m", "way through the hole; 0: none", "choice"},
            s.unmapped_length_m, {0, 5000});
    v.field({"unmapped_margin_m", "m", "stems nearer than this to that way are not in the map",
             "choice: the reach of the sensor"},
            s.unmapped_margin_m, {0, 1000});
  });
  describe(v, s.filter);
}

}  // namespace honka::eval
