#include "algo/localize/consensus/settings.h"

namespace honka {

void describe(SettingsVisitor& v, ConsensusSettings& s) {
  v.field(
      {"stem_sigma_m", "m", "noise of seen against mapped stems on each axis; searches start here",
       "choice: stem detectors list centres to 0.05–0.2 m; the answer's is "
       "estimated"},
      s.stem_sigma_m, Range{0.01, 0.5});
  v.field({"sigma_floor_m", "m", "least noise that an answer may claim",
           "VLP-16 manual: range accuracy 3 cm, 2 cm once many returns are "
           "averaged"},
          s.sigma_floor_m, Range{1e-4, 0.5});
  v.field({"accept_nats", "nats", "evidence over chance and over the runner-up to be accepted",
           "choice: odds of a million to one"},
          s.accept_nats, Range{0.0, 1e4});
  v.field({"least_share", "", "more than this share of the local stems must have partners",
           "choice: a frame mostly beside the map is not in the map"},
          s.least_share, Range{0.0, 1.0});
  v.field({"radial_bias_sds", "",
           "a bias of stems along the line of sight is taken out beyond so many of its s.d.; 0: "
           "always",
           "choice: one unbiased frame in 400"},
          s.radial_bias_sds, Range{0.0, 1e9});
  v.field(
      {"exhaustive_votes", "", "votes that the search of all turns and shifts may cost; 0 is off",
       "choice: about 50 ms"},
      s.exhaustive_votes, Range{0.0, 1e12});
}

}  // namespace honka
