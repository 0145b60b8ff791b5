#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/odometry/key_frames.h"
#include "algo/odometry/odometry.h"
#include "algo/stems/extract.h"
#include "algo/types/settings.h"
#include "eval/config/map_source_settings.h"
#include "sim/harvester/vehicle_settings.h"

namespace honka::eval {

/// Where poses come from: from the scans alone (loam, stems; see algo/odometry), or, for studies,
/// from truth and noise (eval/run/truth_noise_odometry.h).
///
/// Of truth and noise, the error of a pose is a slow drift with exponential covariance over
/// distance, and an independent jitter of every sweep (what one scan-to-map registration leaves).
/// The drift is planar: x, y, and yaw about the sensor. It follows the place, as that of an
/// odometry which registers scans to its map does (coming back, it meets its own map again), or the
/// way travelled, as that of one which only chains scans.
struct OdometrySettings {
  std::string source = "truth+noise";
  std::string drift_follows = "place";
  double drift_m = 0.10;
  double drift_deg = 0.10;
  double correlation_length_m = 150.0;
  double jitter_m = 0.01;
  double jitter_deg = 0.05;
  LidarOdometrySettings lidar = {};
};
void describe(SettingsVisitor& v, OdometrySettings& s);

/// How the trunk map is made.
struct MapSettings {
  std::string source = "prior_run";
  double strip_road_spacing_m = 50.0;
  double thinned_to_per_ha = 0.0;
  StemSettings stems = map_stems();
  sim::VehicleSettings prior_run = prior_vehicle();
  MapSourceSettings sources;

  /// Algorithm 1 for a cloud that gathers a whole run.
  [[nodiscard]] static StemSettings map_stems();
  /// 1 m/s, no work cycle.
  [[nodiscard]] static sim::VehicleSettings prior_vehicle();
};
void describe(SettingsVisitor& v, MapSettings& s);

/// Which windows are localized and when one counts as a success.
struct ProtocolSettings {
  std::vector<std::int64_t> frames = {1, 3, 5, 10};
  double path_length_m = 200.0;
  std::int64_t window_frames = 0;
  std::int64_t windows = 0;
  std::string windows_of = "longest";
  double success_translation_m = 0.5;
  double success_rotation_deg = 2.5;
  double stem_gate_m = 0.5;
};
void describe(SettingsVisitor& v, ProtocolSettings& s);

/// What is run beside the default, on the same windows.
struct VariantSettings {
  bool same_run = true;
  std::vector<double> tolerances_m2 = {3.5, 9.0};
  bool repaired = true;
  std::string methods;
};
void describe(SettingsVisitor& v, VariantSettings& s);

/// What `honka simulate` records.
struct SimulateSettings {
  std::string run = "harvester";
  double start_s = 0.0;
  double duration_s = 60.0;
};
void describe(SettingsVisitor& v, SimulateSettings& s);

}  // namespace honka::eval
