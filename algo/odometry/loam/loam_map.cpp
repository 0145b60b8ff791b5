#include "algo/odometry/loam/loam_map.h"

namespace honka {

LoamMap::LoamMap(const LoamMapSettings& settings)
    // Twice as high as wide: rings are 0.7 m apart at 20 m.
    : edges(settings.edge_voxel_m, 2.0 * settings.edge_voxel_m, settings.points_per_voxel,
            settings.most_voxels),
      planes(settings.plane_voxel_m, settings.plane_voxel_m, settings.points_per_voxel,
             settings.most_voxels) {}

void LoamMap::add(const LoamFeatures& features, const DeskewedFeatures& points,
                  const Pose3& T_odom_lidar, double edge_noise_m, double azimuth_step_rad) {
  for (std::size_t i = 0; i < points.edges_m.size(); ++i) {
    const double grain_m = edge_grain_m(features.edges[i].range_m, azimuth_step_rad);
    edges.insert(T_odom_lidar * points.edges_m[i],
                 1.0 / (edge_noise_m * edge_noise_m + grain_m * grain_m));
  }
  for (const Eigen::Vector3d& point : points.planes_m) planes.insert(T_odom_lidar * point, 1.0);
  edges.keep_near(T_odom_lidar.translation());
  planes.keep_near(T_odom_lidar.translation());
}

void LoamMap::clear() {
  edges.clear();
  planes.clear();
}

double edge_grain_m(double range_m, double azimuth_step_rad) {
  // Each edge is uniform over one step: the middle of two has s.d. step / √24, and where a stem is
  // rough or leans away from the ring as much again.
  constexpr double kShare = 0.4;
  return kShare * range_m * azimuth_step_rad;
}

}  // namespace honka
