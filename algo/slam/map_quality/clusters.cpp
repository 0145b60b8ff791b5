#include "algo/slam/map_quality/clusters.h"

#include <cmath>
#include <limits>

#include "algo/geometry/neighbours.h"

namespace honka {
namespace {

constexpr std::uint32_t kNoCluster = std::numeric_limits<std::uint32_t>::max();

void measure(TreeCluster& cluster, std::span<const Eigen::Vector3d> map_m) {
  for (const std::uint32_t p : cluster.points) cluster.centre_m += map_m[p];
  cluster.centre_m /= static_cast<double>(cluster.points.size());
  for (const std::uint32_t p : cluster.points) {
    cluster.squares_m2 += (map_m[p] - cluster.centre_m).head<2>().squaredNorm();
  }
}

/// Members of each cluster that is large enough; `labels` are lowest members, as indices too.
std::vector<TreeCluster> gather(std::span<const std::uint32_t> labels,
                                std::span<const std::uint32_t> map_index, std::int64_t min_points) {
  std::vector<std::int64_t> sizes(labels.size(), 0);
  for (const std::uint32_t label : labels) ++sizes[label];
  std::vector<std::uint32_t> cluster_of(labels.size(), kNoCluster);
  std::vector<TreeCluster> clusters;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    if (sizes[labels[k]] < min_points) continue;
    std::uint32_t& cluster = cluster_of[labels[k]];
    if (cluster == kNoCluster) {
      cluster = static_cast<std::uint32_t>(clusters.size());
      clusters.emplace_back().points.reserve(static_cast<std::size_t>(sizes[labels[k]]));
    }
    clusters[cluster].points.push_back(map_index[k]);
  }
  return clusters;
}

}  // namespace

void describe(SettingsVisitor& v, ClusterSettings& s) {
  v.field({"link_m", "m", "registrations up to this far apart are of one tree",
           "Nevalainen2021 §2.5: an alpha shape of radius 0.5 m joins up to 1 m"},
          s.link_m, Range{0.001, 100.0});
  v.field({"min_points", "", "registrations that make a tree", "Nevalainen2021 §2.5"}, s.min_points,
          Range{1.0, 1e9});
}

double TreeCluster::rmse_m() const {
  return points.empty() ? 0.0 : std::sqrt(squares_m2 / static_cast<double>(points.size()));
}

std::vector<TreeCluster> tree_clusters(std::span<const Eigen::Vector3d> map_m,
                                       const ClusterSettings& settings) {
  std::vector<Eigen::Vector2d> planar_m;
  std::vector<std::uint32_t> map_index;
  planar_m.reserve(map_m.size());
  map_index.reserve(map_m.size());
  for (std::uint32_t p = 0; p < map_m.size(); ++p) {
    if (!map_m[p].allFinite()) continue;
    planar_m.emplace_back(map_m[p].head<2>());
    map_index.push_back(p);
  }
  if (planar_m.empty()) return {};
  const auto labels = euclidean_clusters<2>(planar_m, settings.link_m, NeighbourSearch::kVoxelHash);
  std::vector<TreeCluster> clusters = gather(labels, map_index, settings.min_points);
  for (TreeCluster& cluster : clusters) measure(cluster, map_m);
  return clusters;
}

RegistrationNoise registration_noise(std::span<const TreeCluster> clusters) {
  RegistrationNoise noise;
  double squares_m2 = 0.0;
  for (const TreeCluster& cluster : clusters) {
    noise.mean_rmse_m += cluster.rmse_m();
    squares_m2 += cluster.squares_m2;
    noise.points += static_cast<std::int64_t>(cluster.points.size());
  }
  noise.clusters = static_cast<std::int64_t>(clusters.size());
  if (clusters.empty()) return noise;
  noise.mean_rmse_m /= static_cast<double>(noise.clusters);
  noise.pooled_rmse_m = std::sqrt(squares_m2 / static_cast<double>(noise.points));
  return noise;
}

RegistrationNoise registration_noise(std::span<const Eigen::Vector3d> map_m,
                                     const ClusterSettings& settings) {
  return registration_noise(tree_clusters(map_m, settings));
}

}  // namespace honka
