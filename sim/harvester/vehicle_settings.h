#pragma once

#include <cstdint>

#include "algo/types/settings.h"

namespace honka::sim {

/// A folding-frame machine and how it works; keys `vehicle.*`. The defaults are the harvester's.
struct VehicleSettings {
  // Driving.
  double drive_speed_m_s = 1.0;
  double acceleration_m_s2 = 0.5;
  bool work_cycle = true;
  double least_hop_m = 2.0;  ///< between two stops
  double most_hop_m = 5.0;
  // Working.
  std::int64_t stems_per_stop = 2;
  double process_s = 6.0;
  double least_swing_deg = 30.0;
  double most_swing_deg = 60.0;
  double swing_rate_deg_s = 15.0;
  // Geometry.
  double front_length_m = 1.9;    ///< joint to front axle
  double rear_length_m = 1.9;     ///< joint to rear axle
  double track_width_m = 2.2;     ///< between the tracks of the wheels
  double joint_to_lidar_m = 2.2;  ///< ahead
  double sensor_height_m = 1.5;   ///< above the ground
  double mount_roll_deg = 0.0;
  double mount_pitch_deg = 0.0;
  double suspension_noise_deg = 0.3;
  bool occluders = true;
};

/// Names every key, unit, range and source of `settings`.
void describe(SettingsVisitor& visitor, VehicleSettings& settings);

/// The forwarder that follows: 1 m/s without a work cycle, crane on the load.
[[nodiscard]] VehicleSettings forwarder_settings();

}  // namespace honka::sim
