#pragma once

#include <array>
#include <vector>

#include "sim/world/trajectory.h"

namespace honka::sim {

/// A pose by its coordinates: x, y, z (m) and roll, pitch, unwrapped yaw (rad).
using PoseKnot = std::array<double, 6>;

/// Truth through evenly spaced knots: Catmull–Rom cubics of position, roll, pitch and yaw, so that
/// velocity and turn rate are continuous.
class KnotTrajectory : public Trajectory {
 public:
  KnotTrajectory() = default;
  /// Knot i is the pose at i · `step_s`; at least two knots.
  KnotTrajectory(double step_s, std::vector<PoseKnot> knots);

  [[nodiscard]] double duration_s() const override;
  [[nodiscard]] Pose3 T_world_lidar(double time_s) const override;

 private:
  double step_s_ = 1.0;
  std::vector<PoseKnot> knots_ = {{}, {}};
};

}  // namespace honka::sim
