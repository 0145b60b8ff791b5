#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/types/settings.h"

namespace honka {

/// What makes a cluster of registrations a tree of the map.
struct ClusterSettings {
  /// Points joined up to this far. An alpha shape of radius 0.5 m joins them up to 1.0 m.
  double link_m = 1.0;
  std::int64_t min_points = 15;
  /// Registrations are rounded to this grid before they are linked (not where they are measured);
  /// 0: linked as they lie. A pair of grid points exactly one link apart is joined.
  double grid_m = 0.05;
};
void describe(SettingsVisitor& v, ClusterSettings& s);

/// A tree of the map: its registrations, and where they lie on the average.
struct TreeCluster {
  std::vector<std::uint32_t> points;  ///< indices into the map, rising
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  double squares_m2 = 0.0;  ///< sum of squared planar distances from the centre

  [[nodiscard]] double rmse_m() const;
};

/// The clusters of at least `min_points`, in order of their first point. Points that are not
/// finite, or 10,000 km away, belong to none. Distances are planar. Source: Nevalainen2021 §2.5.
[[nodiscard]] std::vector<TreeCluster> tree_clusters(std::span<const Eigen::Vector3d> map_m,
                                                     const ClusterSettings& settings);

/// e_C, the tree registration noise of a map; zeros where there is no cluster.
struct RegistrationNoise {
  double mean_rmse_m = 0.0;    ///< mean of the clusters' RMSEs
  double pooled_rmse_m = 0.0;  ///< RMSE of all clustered points from their centres
  std::int64_t clusters = 0, points = 0;
};
[[nodiscard]] RegistrationNoise registration_noise(std::span<const TreeCluster> clusters);
[[nodiscard]] RegistrationNoise registration_noise(std::span<const Eigen::Vector3d> map_m,
                                                   const ClusterSettings& settings);

}  // namespace honka
