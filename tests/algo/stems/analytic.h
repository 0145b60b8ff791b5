#pragma once

#include <cmath>
#include <initializer_list>
#include <vector>

#include "algo/types/angles.h"
#include "algo/types/local_cloud.h"
#include "algo/types/random.h"

namespace honka::analytic {

inline LocalCloud cloud_from(const Eigen::Vector3d& origin_m) { return {{}, {}, {origin_m}}; }

inline void add_point(LocalCloud& cloud, const Eigen::Vector3d& point_m, std::uint32_t frame = 0) {
  cloud.points_m.push_back(point_m);
  cloud.frames.push_back(frame);
}

/// A vertical cylinder as sensor `frame` sees it: `across` beams evenly spread over its width at
/// `rows` heights 0.125 m apart, all on the near half.
inline void add_cylinder(LocalCloud& cloud, const Eigen::Vector2d& centre_m, double radius_m,
                         int across, int rows, std::uint32_t frame = 0, double lowest_m = 0.05) {
  const Eigen::Vector2d ray = (centre_m - cloud.origins_m[frame].head<2>()).normalized();
  const Eigen::Vector2d side(-ray.y(), ray.x());
  for (int row = 0; row < rows; ++row) {
    for (int k = 0; k < across; ++k) {
      const double u = -1.0 + (2.0 * k + 1.0) / across;
      const Eigen::Vector2d at = centre_m + radius_m * (u * side - std::sqrt(1.0 - u * u) * ray);
      add_point(cloud, {at.x(), at.y(), lowest_m + 0.125 * row}, frame);
    }
  }
}

/// Flat ground at z = `height_m`, points 0.19 m apart: no distance meets a threshold over a square
/// about the origin.
inline void add_ground(LocalCloud& cloud, double half_side_m, double height_m, double slope = 0.0) {
  for (double x = -half_side_m; x <= half_side_m; x += 0.19) {
    for (double y = -half_side_m; y <= half_side_m; y += 0.19) {
      add_point(cloud, {x, y, height_m + slope * x});
    }
  }
}

/// A branch: points along a line that rises slowly.
inline void add_branch(LocalCloud& cloud, const Eigen::Vector3d& from_m,
                       const Eigen::Vector3d& to_m, int count) {
  for (int k = 0; k < count; ++k) {
    add_point(cloud, from_m + (to_m - from_m) * (k / (count - 1.0)));
  }
}

/// A stand: cylinders on a grid with ground and branches, seen from the origin at 2 m.
inline LocalCloud stand(std::vector<Eigen::Vector2d>& centres_m, double radius_m = 0.12) {
  LocalCloud cloud = cloud_from({0.0, 0.0, 2.0});
  add_ground(cloud, 16.0, 0.0);
  for (int ix = -2; ix <= 2; ++ix) {
    for (int iy = -2; iy <= 2; ++iy) {
      if (ix == 0 && iy == 0) continue;
      const Eigen::Vector2d centre(6.0 * ix + 0.7 * iy, 6.0 * iy - 0.4 * ix);
      centres_m.push_back(centre);
      add_cylinder(cloud, centre, radius_m, 8, 44);
      add_branch(cloud, {centre.x() + 0.5, centre.y(), 3.0},
                 {centre.x() + 2.0, centre.y() + 0.3, 3.4}, 12);
    }
  }
  return cloud;
}

/// Points without order in a box: what no algorithm may rely on.
inline LocalCloud random_cloud(std::uint64_t seed, int count, double side_m) {
  RandomStream random(seed, "stems_test_cloud");
  LocalCloud cloud = cloud_from(Eigen::Vector3d::Zero());
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-side_m, side_m), y = random.uniform(-side_m, side_m);
    const double z = random.uniform(0.0, 5.0);
    add_point(cloud, {x, y, z});
  }
  return cloud;
}

}  // namespace honka::analytic
