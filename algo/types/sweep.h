#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "algo/types/lidar_model.h"

namespace honka {

/// One echo of one laser shot as the sensor reports it.
struct Return {
  std::uint32_t time_offset_ns = 0;  ///< since Sweep::start_time_s
  std::uint16_t range_ticks = 0;     ///< times LidarModel::range_resolution_m; 0 = no return
  std::uint8_t laser = 0;            ///< id, 0 … lasers − 1
  std::uint8_t reflectivity = 0;     ///< 0–100 diffuse, 101–255 retro-reflective
  std::uint8_t echo = 0;             ///< 0 strongest, 1 last (dual return)

  bool operator==(const Return&) const = default;
};

/// One revolution of the sensor, in the order the beams were shot.
struct Sweep {
  std::int64_t index = 0;
  double start_time_s = 0.0;       ///< of the first firing
  double start_azimuth_rad = 0.0;  ///< manual azimuth (clockwise) at start_time_s
  std::vector<Return> returns;

  /// Manual azimuth at which a return was shot.
  [[nodiscard]] double azimuth_rad(const Return& r, const LidarModel& model) const;
  [[nodiscard]] double time_s(const Return& r) const {
    return start_time_s + 1e-9 * static_cast<double>(r.time_offset_ns);
  }
  /// The point in the lidar frame at the return's own time. Metres.
  [[nodiscard]] Eigen::Vector3d point_in_lidar(const Return& r, const LidarModel& model) const;
};

}  // namespace honka
