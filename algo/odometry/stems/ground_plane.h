#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "algo/odometry/stems/settings.h"
#include "algo/types/lidar_model.h"
#include "algo/types/pose.h"
#include "algo/types/sweep.h"

namespace honka {

/// A return from the ground, in the lidar frame at its own time.
struct GroundPoint {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();
  double share = 0.0;  ///< of the revolution that has passed
};

/// Picks ground returns: in a column of rings, the lowest hits as long as the way from one to the
/// next is no steeper than `max_slope_deg`.
class GroundPicker {
 public:
  GroundPicker(const LidarModel& model, const StemGroundSettings& settings, double min_range_m);
  /// `up`: about where the zenith is in the lidar frame. The answer holds until the next call.
  const std::vector<GroundPoint>& pick(const Sweep& sweep, const Eigen::Vector3d& up);

 private:
  void take_column(const Sweep& sweep, const Eigen::Vector3d& up, double most_slope);

  LidarModel model_;
  StemGroundSettings settings_;
  double min_range_m_;
  std::vector<std::uint8_t> lasers_down_;  ///< below the horizon, lowest first
  std::vector<Return> column_;             ///< by laser; range 0: none
  std::vector<GroundPoint> points_;
};

/// Plane of the ground about a place: z = height at (x, y) + slope · (offset).
struct GroundPlane {
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();

  [[nodiscard]] double above_m(const Eigen::Vector3d& p) const {
    return p.z() - centre_m.z() - slope.dot(p.head<2>() - centre_m.head<2>());
  }
};

/// Heights of the ground in the odom frame: a lattice of cells that wraps around, so that memory is
/// fixed and the newest ground overwrites the oldest.
class GroundMap {
 public:
  explicit GroundMap(const StemGroundSettings& settings);
  void add(const Eigen::Vector3d& point_in_odom);
  /// Plane through the means of the 3 × 3 cells around; nothing where fewer than four are known.
  [[nodiscard]] std::optional<GroundPlane> plane_at(const Eigen::Vector2d& place_m) const;
  void clear();

 private:
  struct Cell {
    std::int32_t ix = INT32_MIN, iy = INT32_MIN;
    std::int32_t points = 0;
    Eigen::Vector3f mean_m = Eigen::Vector3f::Zero();  ///< from the cell's corner; z from 0
  };
  [[nodiscard]] std::size_t at(std::int32_t ix, std::int32_t iy) const;

  StemGroundSettings settings_;
  std::vector<Cell> cells_;
};

}  // namespace honka
