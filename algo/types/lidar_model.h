#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace honka {

/// One laser of a spinning multi-beam lidar.
struct Laser {
  double elevation_rad = 0.0;
  double vertical_offset_m = 0.0;  ///< of the beam's origin along z
  double firing_offset_s = 0.0;    ///< after the start of its firing
};

/// Timing, geometry and resolution of a spinning lidar: what the machine knows of its sensor.
///
/// The sensor turns clockwise seen from above (manual azimuth: clockwise from the sensor's y). In
/// the lidar frame used everywhere else (x ahead, y left, z up) a beam of azimuth α and elevation ε
/// points along (cos ε cos α, −cos ε sin α, sin ε).
struct LidarModel {
  std::string name;
  std::vector<Laser> lasers;        ///< in firing order, which is the order of laser ids
  double firing_period_s = 0.0;     ///< between the starts of two firings
  double rotation_rate_hz = 10.0;   ///< revolutions a second
  double range_resolution_m = 0.0;  ///< of one tick of Return::range_ticks
  double max_range_m = 0.0;

  [[nodiscard]] double sweep_period_s() const { return 1.0 / rotation_rate_hz; }
  /// Unit direction of a beam in the lidar frame.
  [[nodiscard]] Eigen::Vector3d direction(int laser, double azimuth_rad) const;
  /// Origin of a beam in the lidar frame.
  [[nodiscard]] Eigen::Vector3d origin(int laser) const;
};

/// Velodyne VLP-16 (manual 63-9243): 16 lasers, one every 2.304 µs, a firing every 55.296 µs, 2 mm.
[[nodiscard]] LidarModel vlp16(double rotation_rate_hz = 10.0, bool vertical_offsets = false);

}  // namespace honka
