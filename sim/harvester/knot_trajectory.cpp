#include "sim/harvester/knot_trajectory.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka::sim {

KnotTrajectory::KnotTrajectory(double step_s, std::vector<PoseKnot> knots)
    : step_s_(step_s), knots_(std::move(knots)) {
  HONKA_CHECK(step_s > 0.0 && knots_.size() >= 2, "a trajectory needs two knots");
}

double KnotTrajectory::duration_s() const {
  return step_s_ * static_cast<double>(knots_.size() - 1);
}

Pose3 KnotTrajectory::T_world_lidar(double time_s) const {
  const std::size_t last = knots_.size() - 1;
  const double place = std::clamp(time_s / step_s_, 0.0, static_cast<double>(last));
  const std::size_t i = std::min(static_cast<std::size_t>(place), last - 1);
  const double u = place - static_cast<double>(i);
  const PoseKnot& from = knots_[i];
  const PoseKnot& to = knots_[i + 1];
  PoseKnot p;
  for (std::size_t c = 0; c < p.size(); ++c) {
    const double rise = to[c] - from[c];
    const double m0 = i == 0 ? rise : 0.5 * (to[c] - knots_[i - 1][c]);
    const double m1 = i + 1 == last ? rise : 0.5 * (knots_[i + 2][c] - from[c]);
    p[c] = from[c] + u * (m0 + u * ((3 * rise - 2 * m0 - m1) + u * (m0 + m1 - 2 * rise)));
  }
  return pose_from_rpy({p[0], p[1], p[2]}, p[3], p[4], p[5]);
}

}  // namespace honka::sim
