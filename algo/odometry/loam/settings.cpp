#include "algo/odometry/loam/settings.h"

namespace honka {
namespace {

void describe_loam_features(SettingsVisitor& v, LoamFeatureSettings& s) {
  v.field({"min_range_m", "m", "nearer returns are the machine itself",
           "choice: the crane as it is carried ends 3.2 m ahead of the sensor"},
          s.min_range_m, {0.0, 100.0});
  v.field({"max_range_m", "m", "farther features are dropped",
           "choice: a stem of 30 cm has one or two returns a ring there"},
          s.max_range_m, {5.0, 1000.0});
  v.field({"depth_step_m", "m", "a larger step in range ends a surface",
           "choice: the half circle of a thick stem is 0.25 m deep"},
          s.depth_step_m, {0.01, 10.0});
  v.field({"edge_curvature", "", "least curvature at the sides of an edge",
           "Zhang2014 Eq. (1); value a choice: a step of 0.3 m at 10 m"},
          s.edge_curvature, {0.0, 10.0});
  v.field({"plane_curvature", "", "most curvature of a point on a plane",
           "Zhang2014 Eq. (1); value a choice: 4 cm at 10 m, twice the noise of ranges"},
          s.plane_curvature, {0.0, 10.0});
  v.field({"most_edge_width_m", "m", "wider arcs are no stems", "choice"}, s.most_edge_width_m,
          {0.05, 10.0});
  v.field({"sectors", "", "parts of a ring that give planes each",
           "Zhang2014 section V.A has 4; 12 spread them over a view of 210 degrees"},
          s.sectors, {1, 360});
  v.field(
      {"planes_per_sector", "", "most plane points of one part of a ring", "Zhang2014 section V.A"},
      s.planes_per_sector, {1, 1000});
}

void describe_loam_map(SettingsVisitor& v, LoamMapSettings& s) {
  v.field({"edge_voxel_m", "m", "side of a voxel of edges; twice as high",
           "choice: three by three hold one stem"},
          s.edge_voxel_m, {0.05, 10.0});
  v.field({"plane_voxel_m", "m", "side of a voxel of planes",
           "choice: three by three span two rings on the ground nearby"},
          s.plane_voxel_m, {0.05, 10.0});
  v.field({"points_per_voxel", "", "a voxel with so many takes no more", "choice"},
          s.points_per_voxel, {3, 1000000});
  v.field(
      {"most_voxels", "", "of edges and of planes each, 128 bytes a voxel; the farthest go first",
       "choice: 50 MB each, the default stand and its surroundings"},
      s.most_voxels, {1000, 100000000});
}

void describe_loam_registration(SettingsVisitor& v, LoamRegistrationSettings& s) {
  v.field({"edge_noise_m", "m", "s.d. of the axis of a stem, besides the grain of the azimuth",
           "manual: accuracy of a range 3 cm"},
          s.edge_noise_m, {0.001, 1.0});
  v.field(
      {"plane_noise_m", "m", "s.d. of a point off its plane", "manual: accuracy of a range 3 cm"},
      s.plane_noise_m, {0.001, 1.0});
  v.field({"robust_scale", "", "of the Cauchy weights, in s.d.", "choice"}, s.robust_scale,
          {0.1, 100.0});
  v.field({"gate_m", "m", "most distance between a feature and its line or plane", "choice"},
          s.gate_m, {0.05, 10.0});
  v.field({"prior_m", "m", "s.d. of the way against constant velocity, a sweep",
           "choice: six times what 0.5 m/s2 does in 0.1 s"},
          s.prior_m, {0.0001, 10.0});
  v.field({"prior_deg", "deg", "s.d. of the turn against constant velocity, a sweep",
           "choice: springs at 1.5 Hz and 0.3 degrees"},
          s.prior_deg, {0.001, 180.0});
  v.field({"degenerate_sigma_m", "m",
           "directions known worse than this follow the prediction; radians count 10 m",
           "Zhang2016 section III; value a choice: what a machine drives in one sweep"},
          s.degenerate_sigma_m, {0.001, 100.0});
  v.field({"sweep_rounds", "", "matchings of each sweep", "choice"}, s.sweep_rounds, {1, 100});
  v.field({"sweep_features", "", "most edges, and planes, in them", "choice: speed"},
          s.sweep_features, {10, 100000});
  v.field({"map_rounds", "", "matchings of a key frame with all its features", "choice"},
          s.map_rounds, {1, 100});
}

void describe_loam_motion(SettingsVisitor& v, LoamMotionSettings& s) {
  v.field({"jump_m", "m", "more off the prediction in one sweep is a jump",
           "choice: 50 m/s2, what no machine survives"},
          s.jump_m, {0.01, 100.0});
  v.field({"jump_deg", "deg", "the same for the turn", "choice"}, s.jump_deg, {0.1, 180.0});
  v.field({"most_speed_m_s", "m/s", "what a gap adds to jump_m, by the second",
           "Komatsu 931: at work up to 8 km/h, with a margin"},
          s.most_speed_m_s, {0.0, 100.0});
  v.field({"most_turn_deg_s", "deg/s", "what a gap adds to jump_deg, by the second",
           "choice: twice a quick swing"},
          s.most_turn_deg_s, {0.0, 360.0});
  v.field({"lost_share", "", "fewer edges on lines than this share of the usual: look around",
           "choice"},
          s.lost_share, {0.0, 1.0});
  v.field({"recovery_radius_m", "m", "how far around to look", "choice: beyond a jump of 5 m"},
          s.recovery_radius_m, {0.0, 50.0});
}

}  // namespace

void describe(SettingsVisitor& v, LoamSettings& s) {
  v.group("features", [&] { describe_loam_features(v, s.features); });
  v.group("map", [&] { describe_loam_map(v, s.map); });
  v.group("registration", [&] { describe_loam_registration(v, s.registration); });
  v.group("motion", [&] { describe_loam_motion(v, s.motion); });
  v.field(
      {"key_distance_m", "m", "least way between two key frames of the map", "Li2020 section 2.6"},
      s.key_distance_m, {0.001, 1000.0});
  v.field({"key_angle_deg", "deg", "least turn between them, where the way is shorter",
           "Li2020 section 2.6"},
          s.key_angle_deg, {0.1, 180.0});
}

}  // namespace honka
