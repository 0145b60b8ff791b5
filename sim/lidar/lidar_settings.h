#pragma once

#include <cstdint>
#include <string>

#include "algo/types/lidar_model.h"
#include "algo/types/settings.h"

namespace honka::sim {

/// The sensor of a scenario; keys `lidar.*`.
struct LidarSettings {
  std::string model = "vlp16";
  double rotation_rate_hz = 10.0;
  double field_of_view_deg = 210.0;  ///< about the x axis, which looks ahead
  bool vertical_offsets = false;     ///< of the beams' origins
  double min_range_m = 0.5;
  double max_range_m = 100.0;
  double range_noise_m = 0.010;  ///< repeatability, 1 σ
  double range_bias_m = 0.030;   ///< a laser's bias is uniform in ± this
  double divergence_horizontal_mrad = 3.0;
  double divergence_vertical_mrad = 1.5;
  std::int64_t sub_rays = 1;
  double pulse_resolution_m = 0.4;
  std::string return_mode = "strongest";
  double drop_out = 0.002;
  double half_detection_range_m = 60.0;  ///< of a 10 % target at normal incidence; 0 = no limit
};

/// Names every key, unit, range and source of `settings`.
void describe(SettingsVisitor& visitor, LidarSettings& settings);

/// The laser and firing table that `settings.model` names. Throws UserError for unknown names.
[[nodiscard]] LidarModel make_lidar_model(const LidarSettings& settings);

}  // namespace honka::sim
