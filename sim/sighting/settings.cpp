#include "sim/sighting/settings.h"

namespace honka::sim {

void describe(SettingsVisitor& v, SightingSettings& s) {
  v.field({"range_m", "m", "stems farther away are not listed",
           "stems of one VLP-16 sweep thin out beyond 30 m"},
          s.range_m, {1, 200});
  v.field({"field_of_view_deg", "deg", "about the sensor's x axis", "Li2020 2.2"},
          s.field_of_view_deg, {1, 360});
  v.field({"most_stems", "", "the list holds the nearest so many, false ones counted; 0: all",
           "choice"},
          s.most_stems, {0, 100000});
  v.field({"noise_m", "m", "s.d. of a listed stem on each axis",
           "unbiased centres of one sweep: 0.04 to 0.06 m"},
          s.noise_m, {0, 10});
  v.field({"radial_bias_m", "m", "listed stems lie so much nearer to the sensor",
           "choice; plain means of one-sided views: 0.79 of the stem's radius"},
          s.radial_bias_m, {-1, 1});
  v.field({"missed_share", "", "probability that a stem in view is not listed", "choice"},
          s.missed_share, {0, 1});
  v.field({"false_share", "", "share of the list that is no stem, anywhere in the view", "choice"},
          s.false_share, {0, 0.95});
}

void describe(SettingsVisitor& v, MappingSettings& s) {
  v.field({"stems", "", "trees of the forest", "Li2020 2.1: 2,200"}, s.stems, {1, 5e6});
  v.field({"noise_m", "m", "s.d. of a mapped stem on each axis", "choice"}, s.noise_m, {0, 10});
  v.field({"missed_share", "", "probability that a tree is not in the map", "choice"},
          s.missed_share, {0, 1});
  v.field({"felled_share", "", "probability that a mapped tree has been felled since", "choice"},
          s.felled_share, {0, 1});
  v.field({"grown_share", "", "probability that a tree has grown up since: it stands, unmapped",
           "choice"},
          s.grown_share, {0, 1});
}

}  // namespace honka::sim
