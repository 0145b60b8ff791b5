#include "algo/slam/map_quality/clusters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "algo/geometry/neighbours.h"

namespace honka {
namespace {

/// No map reaches this far; beyond it, cells of some centimetres run out of numbers.
constexpr double kFarthest_m = 1e7;
constexpr std::uint32_t kNoCluster = std::numeric_limits<std::uint32_t>::max();

void measure(TreeCluster& cluster, std::span<const Eigen::Vector3d> map_m) {
  for (const std::uint32_t p : cluster.points) cluster.centre_m += map_m[p];
  cluster.centre_m /= static_cast<double>(cluster.points.size());
  for (const std::uint32_t p : cluster.points) {
    cluster.squares_m2 += (map_m[p] - cluster.centre_m).head<2>().squaredNorm();
  }
}

/// The distinct grid points of a map, and the one that each of its points is rounded to.
struct GridPoints {
  std::vector<Eigen::Vector2d> points_m;
  std::vector<std::uint32_t> of;
};

GridPoints rounded_to(std::span<const Eigen::Vector2d> planar_m, double grid_m) {
  std::vector<std::pair<double, double>> cells;
  cells.reserve(planar_m.size());
  for (const Eigen::Vector2d& p : planar_m) {
    cells.emplace_back(std::round(p.x() / grid_m), std::round(p.y() / grid_m));
  }
  std::vector<std::uint32_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(cells[a], a) < std::tie(cells[b], b);
  });
  GridPoints grid;
  grid.of.resize(cells.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto& cell = cells[order[k]];
    if (k == 0 || cell != cells[order[k - 1]]) {
      grid.points_m.emplace_back(cell.first * grid_m, cell.second * grid_m);
    }
    grid.of[order[k]] = static_cast<std::uint32_t>(grid.points_m.size() - 1);
  }
  return grid;
}

/// A label of each point; the same within a cluster, and below the number of points.
std::vector<std::uint32_t> cluster_labels(std::span<const Eigen::Vector2d> planar_m,
                                          const ClusterSettings& settings) {
  if (!(settings.grid_m > 0.0)) {
    return euclidean_clusters<2>(planar_m, settings.link_m, NeighbourSearch::kVoxelHash);
  }
  const GridPoints grid = rounded_to(planar_m, settings.grid_m);
  // Up to the link and not only below it.
  const double link_m = std::nextafter(settings.link_m, 2.0 * settings.link_m);
  const auto of_grid = euclidean_clusters<2>(grid.points_m, link_m, NeighbourSearch::kVoxelHash);
  std::vector<std::uint32_t> labels;
  labels.reserve(planar_m.size());
  for (const std::uint32_t point : grid.of) labels.push_back(of_grid[point]);
  return labels;
}

/// Members of each cluster that is large enough; in order of their first.
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
  v.field({"grid_m", "m", "registrations are rounded to this grid before they are linked; 0: none",
           "choice: below the noise of a registration"},
          s.grid_m, Range{0.0, 1.0});
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
    if (!map_m[p].allFinite() || map_m[p].cwiseAbs().maxCoeff() > kFarthest_m) continue;
    planar_m.emplace_back(map_m[p].head<2>());
    map_index.push_back(p);
  }
  if (planar_m.empty()) return {};
  std::vector<TreeCluster> clusters =
      gather(cluster_labels(planar_m, settings), map_index, settings.min_points);
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
