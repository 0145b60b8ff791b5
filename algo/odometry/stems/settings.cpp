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

void describe(SettingsVisitor& v, StemGroundSettings& s) {
  v.field({"firing_step", "", "every how many firings the ground is looked at",
           "choice: some 85 columns over 210 degrees"},
          s.firing_step, {1, 1000});
  v.field({"max_range_m", "m", "farther ground is not used", "choice: rings graze it there"},
          s.max_range_m, {3.0, 100.0});
  v.field({"max_slope_deg", "deg", "steeper between two rings is no ground", "choice"},
          s.max_slope_deg, {1.0, 80.0});
  v.field({"cell_m", "m", "side of a cell of the ground's map", "choice"}, s.cell_m, {0.1, 10.0});
  v.field({"cells", "", "cells of that map along each side; it moves with the machine",
           "choice: 256 m, 3 MB"},
          s.cells, {16, 4096});
  v.field({"tolerance_m", "m", "points higher above or below the map's ground are not ground",
           "choice: logs and shrubs stand out"},
          s.tolerance_m, {0.01, 2.0});
  v.field({"sigma_m", "m", "s.d. of a ground point against the map",
           "choice: tussocks and stones between the points"},
          s.sigma_m, {0.001, 1.0});
}

void describe(SettingsVisitor& v, StemLandmarkSettings& s) {
  v.field({"key_distance_m", "m", "the map learns from a sweep this far from the last such",
           "Nevalainen2021 0.25 m, Li2020 0.3 m"},
          s.key_distance_m, {0.001, 100.0});
  v.field({"key_angle_deg", "deg", "or turned by this", "Nevalainen2021: 3 degrees"},
          s.key_angle_deg, {0.1, 180.0});
  v.field({"radius_m", "m", "landmarks within this are compared with a sweep",
           "choice: the range of stems and a drive of 5 m"},
          s.radius_m, {5.0, 1000.0});
  v.field({"apart_m", "m", "no landmark is made this near another", "choice"}, s.apart_m,
          {0.0, 10.0});
  v.field({"lean_deg", "deg", "s.d. of the lean of a tree about either axis",
           "choice: a landmark's prior is to stand; this keeps the map level"},
          s.lean_deg, {0.0, 45.0});
  v.field({"sigma_m", "m", "least s.d. of a stem's place against its landmark",
           "choice: bark, taper and the side it is seen from"},
          s.sigma_m, {0.0001, 1.0});
  v.field({"slope_sigma_deg", "deg", "the same for the direction of its axis",
           "choice: stems are crooked"},
          s.slope_sigma_deg, {0.001, 45.0});
  v.field({"confirm", "", "a landmark seen less often is forgotten", "choice"}, s.confirm,
          {1, 1000});
  v.field({"forget_key_frames", "", "after so many key frames without it", "choice"},
          s.forget_key_frames, {1, 1000000});
  v.field({"max_landmarks", "", "most landmarks; beyond it the longest unseen is forgotten",
           "choice: 100 hectares in 3 MB"},
          s.max_landmarks, {100, 10000000});
}

void describe(SettingsVisitor& v, StemRegistrationSettings& s) {
  v.field({"gate_m", "m", "a stem and its landmark are nearer than this",
           "choice: a fifth of the distance between trees"},
          s.gate_m, {0.01, 10.0});
  v.field({"min_stems", "", "least stems of a registration", "choice: one more than determine it"},
          s.min_stems, {3, 1000});
  v.field({"min_share", "", "least share of the stems that fit; below it the place is searched",
           "choice: chance gives 0.03"},
          s.min_share, {0.0, 1.0});
  v.field({"acceleration_m_s2", "m/s2", "s.d. of the machine's acceleration",
           "choice: a heavy machine"},
          s.acceleration_m_s2, {0.001, 100.0});
  v.field({"turn_acceleration_deg_s2", "deg/s2", "s.d. of its turning acceleration",
           "choice: a swing of 15 degrees a second within a second"},
          s.turn_acceleration_deg_s2, {0.01, 10000.0});
  v.field({"degenerate_m", "m", "a direction with a larger s.d. follows the prediction", "choice"},
          s.degenerate_m, {0.001, 100.0});
  v.field({"degenerate_deg", "deg", "the same for rotations", "choice"}, s.degenerate_deg,
          {0.001, 180.0});
  v.field({"search_m", "m", "how far from the prediction a lost place is searched",
           "choice: a jump of 5 m is found"},
          s.search_m, {0.0, 50.0});
  v.field({"search_deg", "deg", "and how far turned", "choice"}, s.search_deg, {0.0, 180.0});
  v.field(
      {"restart_sweeps", "", "sweeps without a place after which the map begins anew", "choice"},
      s.restart_sweeps, {1, 100000});
}

void describe(SettingsVisitor& v, StemOdometrySettings& s) {
  v.group("points", [&] { describe(v, s.points); });
  v.group("ground", [&] { describe(v, s.ground); });
  v.group("landmarks", [&] { describe(v, s.landmarks); });
  v.group("registration", [&] { describe(v, s.registration); });
}

}  // namespace honka
