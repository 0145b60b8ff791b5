#include "sim/lidar/sweep_poses.h"

#include <cmath>

namespace honka::sim {

SweepPoses::SweepPoses(const Trajectory& trajectory, double start_time_s, double duration_s) {
  const auto count = static_cast<std::size_t>(std::floor(duration_s / kKnot_s)) + 2;
  knots_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Pose3 pose = trajectory.T_world_lidar(start_time_s + kKnot_s * static_cast<double>(i));
    Matrix34 m;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        m[4 * row + column] =
            pose.matrix()(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
      }
    }
    knots_.push_back(m);
  }
}

}  // namespace honka::sim
