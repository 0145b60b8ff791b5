#pragma once

#include <vector>

#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/random.h"

namespace honka::test {

using StemPoints = std::vector<Eigen::Vector3d>;

/// Stems at random, at least 1 m apart, in a square of the given side about the origin.
inline StemPoints random_stems(std::size_t count, double side_m, std::uint64_t id) {
  RandomStream random(11, "random_stems", {id});
  StemPoints stems;
  while (stems.size() < count) {
    const double x = random.uniform(-0.5, 0.5) * side_m, y = random.uniform(-0.5, 0.5) * side_m;
    const Eigen::Vector3d stem(x, y, 0.02 * x + random.normal(0.0, 0.3));
    bool apart = true;
    for (const Eigen::Vector3d& other : stems) apart &= (other - stem).norm() > 1.0;
    if (apart) stems.push_back(stem);
  }
  return stems;
}

/// What a scanner at T_world_lidar sees of the stems, with noise.
inline StemPoints seen_from(const StemPoints& stems, const Pose3& T_world_lidar, double noise_m,
                            std::uint64_t id) {
  RandomStream random(11, "seen_from", {id});
  StemPoints points;
  for (const Eigen::Vector3d& stem : stems) {
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d point = T_world_lidar.inverse() * stem + noise_m * noise;
    if (ViewCone{}.holds(point.head<2>())) points.push_back(point);
  }
  return points;
}

}  // namespace honka::test
