#include "algo/localize/li2020/settings.h"

namespace honka {

void describe(SettingsVisitor& v, Li2020Settings& s) {
  v.field({"tolerance_m2", "m2", "largest |dA| + |dL²| of a triangle pair, centre and neighbours",
           "choice: Li2020 prints none; 3.5–4.5 comes nearest to its figures"},
          s.tolerance_m2, Range{0.0, 1e4});
  v.field({"neighbours_required", "", "neighbours of three that must be within the tolerance",
           "Li2020 §2.8; fewer than 3 ruins the pose"},
          s.neighbours_required, Range{1.0, 3.0});
  v.field({"pairing", "", "corner pairs: the closest of 9 sides, or the rotation of least side sum",
           "Li2020 Eq. (2); least_side_sum is a variant"},
          s.pairing, {"similar_edge", "least_side_sum"});
  v.field({"vertex_gate_m", "m", "drop matches with a vertex residual above this; 0 is off",
           "variant of Li2020 §2.8.2; 0.3 helps"},
          s.vertex_gate_m, Range{0.0, 100.0});
  v.field({"selection", "",
           "Eq. (4) over the matches' own poses, or continuous in their box: nearby, or globally",
           "Li2020 Eq. (4); branch and bound: Li2020 4, future work"},
          s.selection, {"candidates", "box", "branch_and_bound"});
  v.field({"agreement_m", "m", "mean residual of a match's vertex pairs below which it agrees",
           "choice: Li2020 does not define success"},
          s.agreement_m, Range{0.0, 100.0});
  v.field({"min_agreeing", "", "agreeing matches that make a pose accepted",
           "choice: reproduces Li2020 Table 1 from its mean counts"},
          s.min_agreeing, Range{1.0, 1e6});
  v.field({"local_radius_m", "m", "only local stems this near are triangulated; 0 is all",
           "Li2020 4, future work"},
          s.local_radius_m, Range{0.0, 1e4});
  v.field({"submap_size_m", "m", "side of a tile of the map, each with its own graph; 0 is one map",
           "variant: overlapping sub-maps for large forests"},
          s.submap_size_m, Range{0.0, 1e6});
  v.field({"submap_overlap_m", "m", "that neighbouring tiles share",
           "choice: twice the reach of the sensor"},
          s.submap_overlap_m, Range{0.0, 1e6});
  v.field(
      {"stars", "", "corners of stars: x, y; or x, y and height, for a sensor that stands tilted",
       "Li2020 §4.1, future work: \"defined in actual 3D\""},
      s.stars, {"plane", "space"});
}

}  // namespace honka
