#include "eval/config/experiment_settings.h"

namespace honka::eval {

void describe(SettingsVisitor& v, OdometrySettings& s) {
  Choices sources = {"truth+noise"};
  sources.insert(sources.end(), odometry_names().begin(), odometry_names().end());
  v.field({"source", "", "where poses come from: truth and noise, or an odometry of the scans",
           "Li2020 2.6 takes LOAM"},
          s.source, sources);
  v.field({"drift_follows", "", "place: revisits agree; way: every metre adds",
           "LOAM registers scans to its map (Li2020 2.6)"},
          s.drift_follows, {"place", "way"});
  v.field({"drift_m", "m", "s.d. of the slow drift of x and of y",
           "choice: map drift of lidar mapping over a stand"},
          s.drift_m, {0, 100});
  v.field({"drift_deg", "deg", "s.d. of the slow drift of yaw", "choice, as drift_m"}, s.drift_deg,
          {0, 90});
  v.field({"correlation_length_m", "m", "distance over which the drift forgets itself",
           "drift of 0.5 % over 10 m, the class of LOAM (Zhang & Singh 2014)"},
          s.correlation_length_m, {0.1, 1e6});
  v.field({"jitter_m", "m", "s.d. of x, y, z, independent at each key frame",
           "choice: residual of a scan-to-map registration"},
          s.jitter_m, {0, 10});
  v.field({"jitter_deg", "deg", "s.d. of roll, pitch, yaw, independent at each key frame",
           "choice, as jitter_m"},
          s.jitter_deg, {0, 90});
  describe(v, s.lidar);
}

StemSettings MapSettings::map_stems() {
  StemSettings settings = map_stem_settings();
  // Stems farther away are one ring thick and sway with the roll of the machine.
  settings.max_range_m = 35.0;
  return settings;
}

sim::VehicleSettings MapSettings::prior_vehicle() {
  sim::VehicleSettings settings;
  settings.work_cycle = false;
  settings.drive_speed_m_s = 1.0;
  return settings;
}

void describe(SettingsVisitor& v, MapSettings& s) {
  v.field({"source", "", "the run whose scans make the map, or a list of trees of another source",
           "Li2020 2.2: the paper's is the same run; a fair trial needs a prior one; Li2020 4: "
           "inventories and airborne scans"},
          s.source, {"prior_run", "same_run", "inventory", "airborne"});
  v.field({"strip_road_spacing_m", "m", "between the strip roads that the prior run drives",
           "choice: 1,200 m through 200 x 300 m, the preprint's trail"},
          s.strip_road_spacing_m, {10, 500});
  v.field({"thinned_to_per_ha", "1/ha",
           "stems that a thinning between the prior run and the localized one leaves; 0: none",
           "choice: a forwarder follows a harvester"},
          s.thinned_to_per_ha, {0, 20000});
  v.group("stems", [&] { describe(v, s.stems); });
  v.group("prior_run", [&] { describe(v, s.prior_run); });
  describe(v, s.sources);
}

void describe(SettingsVisitor& v, ProtocolSettings& s) {
  v.field({"frames", "", "key frames in a window, one row each", "Li2020 Table 1"}, s.frames,
          {1, 100});
  v.field({"path_length_m", "m", "of the drive that is localized", "Li2020 2.1"}, s.path_length_m,
          {5, 5000});
  v.field(
      {"window_frames", "",
       "key frames in each window of a study of trials; 0: the last of protocol.frames", "choice"},
      s.window_frames, {0, 1000});
  v.field(
      {"windows", "", "disjoint windows a stand at most; 0 for all that the drive holds", "choice"},
      s.windows, {0, 100000});
  v.field({"windows_of", "",
           "longest: all numbers of frames end where the longest windows do; each: "
           "each number has disjoint windows of its own",
           "choice"},
          s.windows_of, {"longest", "each"});
  v.field(
      {"success_translation_m", "m", "a success lies within", "Li2020 3.2: largest error 0.5 m"},
      s.success_translation_m, {0.01, 100});
  v.field({"success_rotation_deg", "deg", "and within", "Li2020 3.2: largest error 2.23 deg"},
          s.success_rotation_deg, {0.01, 180});
  v.field({"stem_gate_m", "m", "a found stem is true when a tree stands this near", "choice"},
          s.stem_gate_m, {0.05, 5});
}

void describe(SettingsVisitor& v, VariantSettings& s) {
  v.field({"same_run", "", "also with the map made by the localized run itself",
           "Li2020 2.2, the paper's protocol"},
          s.same_run);
  v.field({"tolerances_m2", "m2", "also with these tolerances of a match", "the paper names none"},
          s.tolerances_m2, {0, 1000});
  v.field({"repaired", "", "also with height band and unbiased centres", "choice"}, s.repaired);
  v.field({"methods", "", "matchers side by side on the same stems, with commas between", "choice"},
          s.methods, {});
}

void describe(SettingsVisitor& v, SimulateSettings& s) {
  v.field({"run", "", "which drive is recorded", "choice"}, s.run, {"harvester", "prior_run"});
  v.field({"start_s", "s", "start of the recording within the drive", "choice"}, s.start_s,
          {0, 1e6});
  v.field({"duration_s", "s", "length of the recording; cut at the end of the drive", "choice"},
          s.duration_s, {0.05, 1e6});
}

}  // namespace honka::eval
