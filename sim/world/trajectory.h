#pragma once

#include "algo/types/pose.h"

namespace honka::sim {

/// Truth: the 6-DoF pose of a lidar as a continuous function of time.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  [[nodiscard]] virtual double duration_s() const = 0;
  /// Pose at any time in [0, duration]; outside it the nearest end.
  [[nodiscard]] virtual Pose3 T_world_lidar(double time_s) const = 0;
};

/// A sensor that stands still, for analytic worlds and benchmarks.
class StaticTrajectory : public Trajectory {
 public:
  StaticTrajectory(const Pose3& T_world_lidar, double duration_s)
      : pose_(T_world_lidar), duration_s_(duration_s) {}
  [[nodiscard]] double duration_s() const override { return duration_s_; }
  [[nodiscard]] Pose3 T_world_lidar(double) const override { return pose_; }

 private:
  Pose3 pose_;
  double duration_s_;
};

}  // namespace honka::sim
