// Stems with heights, and what a tilted sensor sees of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "algo/types/pose.h"
#include "algo/types/random.h"

namespace honka::test {

using SpacePoints = std::vector<Eigen::Vector3d>;

/// Heights of the ground over a place.
using Ground = double (*)(const Eigen::Vector2d&);
inline double flat_ground(const Eigen::Vector2d&) { return 0.0; }
inline double rough_ground(const Eigen::Vector2d& p) {
  return 0.15 * p.x() + 1.5 * std::sin(0.2 * p.y()) + 0.4 * std::sin(1.7 * p.x());
}

/// 400 stems in 80 m × 80 m, no two closer than 1.5 m.
inline SpacePoints stems_on(Ground ground, std::uint64_t seed = 1) {
  RandomStream stream(seed, "space_stars_forest");
  SpacePoints stems;
  while (stems.size() < 400) {
    const double x = stream.uniform(0.0, 80.0);
    const Eigen::Vector2d p(x, stream.uniform(0.0, 80.0));
    const bool free = std::none_of(stems.begin(), stems.end(),
                                   [&](const auto& q) { return (p - q.head(2)).norm() < 1.5; });
    if (free) stems.emplace_back(p.x(), p.y(), ground(p));
  }
  return stems;
}

inline SpacePoints moved_in_space(const Pose3& T, SpacePoints points) {
  for (Eigen::Vector3d& p : points) p = T * p;
  return points;
}

/// What stands within 25 m of a sensor, in its frame.
inline SpacePoints seen_in_space(const SpacePoints& map, const Pose3& T_map_local) {
  SpacePoints near;
  for (const Eigen::Vector3d& p : map) {
    if ((p - T_map_local.translation()).norm() < 25.0) near.push_back(p);
  }
  return moved_in_space(T_map_local.inverse(), near);
}

inline Pose3 tilted_pose(double roll_deg, double pitch_deg, double yaw_rad) {
  return pose_from_rpy({41.0, 38.0, rough_ground({41.0, 38.0}) + 2.0}, deg_to_rad(roll_deg),
                       deg_to_rad(pitch_deg), yaw_rad);
}

}  // namespace honka::test
