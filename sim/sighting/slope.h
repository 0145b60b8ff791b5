#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "sim/sighting/sight.h"

namespace honka::sim {

/// A forest on a plane slope that rises along x, from height 0 at x = 0. Trees stand where they
/// stand in plan; `along` has their feet as they lie along the ground, x up the slope.
struct SlopedForest {
  SlopedForest(const MappedForest& in_plan, double slope_rad);

  /// Height of the ground at a place of the plan.
  [[nodiscard]] double height_m(const Eigen::Vector2d& place_m) const;
  /// The ground's frame: origin where the plan's is, x up the slope, z away from the ground.
  [[nodiscard]] Pose3 T_world_ground() const;
  /// A sensor on the ground above or below a place of the plan, its z away from the ground, its x
  /// at the yaw along the ground.
  [[nodiscard]] Pose3 T_world_sensor(const Pose2& place) const;

  double slope_rad = 0.0;
  MappedForest along;
};

/// What a stem detector lists at a tilted sensor: the foot of each stem, in the sensor's frame.
struct SlopeSighting {
  Pose3 T_world_sensor;
  std::vector<Eigen::Vector3d> stems_in_sensor_m;
  std::vector<std::int32_t> trees;  ///< of each: index into the forest's trees, −1 for none
};

/// As `sight` lists stems on level ground, along the ground; then each foot, false ones too, is off
/// by `height_noise_m` (s.d.) along the sensor's z. `place` in plan, see T_world_sensor. The digits
/// depend on (seed, query) and the arguments alone; x and y of slope 0 are those of `sight`.
[[nodiscard]] SlopeSighting sight_on_slope(const SlopedForest& forest, const Pose2& place,
                                           const SightingSettings& settings, double height_noise_m,
                                           std::uint64_t seed, std::uint64_t query);

}  // namespace honka::sim
