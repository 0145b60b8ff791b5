#include "algo/odometry/stems/settings.h"

namespace honka {

void describe(SettingsVisitor& v, StemPointSettings& s) {
  v.field({"min_range_m", "m", "nearer returns are dropped: the machine itself",
           "choice: the crane as it is carried ends 3.2 m ahead of the sensor"},
          s.min_range_m, {0.0, 1000.0});
  v.field(
      {"max_range_m", "m", "farther returns are dropped", "choice: rings are 1.4 m apart there"},
      s.max_range_m, {1.0, 1000.0});
  v.field({"range_jump_m", "m", "neighbours on a ring that differ by more are two things",
           "choice: the outermost return of a stem lies up to its radius behind the next"},
          s.range_jump_m, {0.01, 2.0});
  v.field({"background_m", "m", "what stands free has this much depth behind it on both sides",
           "choice: twice range_jump_m"},
          s.background_m, {0.0, 10.0});
  v.field({"max_width_m", "m", "wider arcs are no stem", "choice: the thickest trees"},
          s.max_width_m, {0.05, 5.0});
  v.field({"min_rings", "", "least arcs above each other", "choice: two always fit a line"},
          s.min_rings, {2, 128});
  v.field({"min_span_m", "m", "least height between the lowest and the highest arc", "choice"},
          s.min_span_m, {0.0, 20.0});
  v.field({"max_lean_deg", "deg", "stems that lean more are dropped", "choice"}, s.max_lean_deg,
          {1.0, 60.0});
  v.field({"max_bend_m", "m", "arcs farther than this and two s.d. from the axis are dropped",
           "choice: bark and taper stay below"},
          s.max_bend_m, {0.001, 1.0});
  v.field({"range_sigma_m", "m", "s.d. of a range", "VLP-16 data sheet 63-9229: up to 3 cm"},
          s.range_sigma_m, {0.0001, 1.0});
}

void describe(SettingsVisitor& v, VerticalSettings& s) {
  v.field({"min_stems", "", "with fewer stems the ground's normal is taken",
           "choice: two more than the fit has unknowns"},
          s.min_stems, {3, 1000});
  v.field({"merge_m", "m", "sightings of several sweeps this near are one stem", "choice"},
          s.merge_m, {0.0, 10.0});
  v.field({"ground_range_m", "m", "ground within this range carries the plane", "choice"},
          s.ground_range_m, {3.0, 100.0});
  v.field({"ground_slope_deg", "deg", "s.d. of the ground's slope about either axis",
           "choice: gentle terrain"},
          s.ground_slope_deg, {0.0, 45.0});
  v.group("points", [&] { describe(v, s.points); });
}

void describe(SettingsVisitor& v, StemOdometrySettings& s) {
  v.group("points", [&] { describe(v, s.points); });
}

}  // namespace honka
