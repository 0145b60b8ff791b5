#include "algo/types/lidar_model.h"

#include <array>
#include <cmath>

#include "algo/types/angles.h"

namespace honka {

Eigen::Vector3d LidarModel::direction(int laser, double azimuth_rad) const {
  const double elevation = lasers[static_cast<std::size_t>(laser)].elevation_rad;
  const double horizontal = std::cos(elevation);
  return {horizontal * std::cos(azimuth_rad), -horizontal * std::sin(azimuth_rad),
          std::sin(elevation)};
}

Eigen::Vector3d LidarModel::origin(int laser) const {
  return {0.0, 0.0, lasers[static_cast<std::size_t>(laser)].vertical_offset_m};
}

LidarModel vlp16(double rotation_rate_hz, bool vertical_offsets) {
  // Manual 63-9243, table 9-1: elevation by laser id.
  constexpr std::array<double, 16> kElevation_deg = {-15, 1, -13, 3,  -11, 5,  -9, 7,
                                                     -7,  9, -5,  11, -3,  13, -1, 15};
  constexpr double kLaserPeriod_s = 2.304e-6;
  constexpr double kVerticalOffset_m = -0.0419;  // times tan(elevation), table 9-1
  LidarModel model;
  model.name = "vlp16";
  model.firing_period_s = 55.296e-6;
  model.rotation_rate_hz = rotation_rate_hz;
  model.range_resolution_m = 0.002;
  model.max_range_m = 100.0;
  for (std::size_t id = 0; id < kElevation_deg.size(); ++id) {
    const double elevation = deg_to_rad(kElevation_deg[id]);
    model.lasers.push_back({elevation,
                            vertical_offsets ? kVerticalOffset_m * std::tan(elevation) : 0.0,
                            kLaserPeriod_s * static_cast<double>(id)});
  }
  return model;
}

}  // namespace honka
