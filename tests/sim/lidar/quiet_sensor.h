#pragma once

#include "sim/lidar/lidar_settings.h"

namespace honka::sim {

/// A VLP-16 without noise, bias and losses: its answers are on paper.
[[nodiscard]] inline LidarSettings quiet_sensor() {
  LidarSettings settings;
  settings.range_noise_m = 0.0;
  settings.range_bias_m = 0.0;
  settings.drop_out = 0.0;
  settings.half_detection_range_m = 0.0;
  return settings;
}

}  // namespace honka::sim
