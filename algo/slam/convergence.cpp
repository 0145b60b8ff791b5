#include "algo/slam/convergence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algo/delaunay/delaunay.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// Per point: the mean length of its Delaunay edges, 0 for a point without.
std::vector<double> mean_edge_lengths_m(const DelaunayGraph& graph) {
  const std::vector<Eigen::Vector2d>& places = graph.vertices;
  std::vector<double> sum_m(places.size(), 0.0), edges(places.size(), 0.0);
  for (const DelaunayTriangle& triangle : graph.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto from = static_cast<std::size_t>(triangle.vertices[(k + 1) % 3]);
      const auto to = static_cast<std::size_t>(triangle.vertices[(k + 2) % 3]);
      // An inner edge is met twice, once from each of its triangles.
      const double weight = triangle.neighbours[k] < 0 ? 1.0 : 0.5;
      const double length_m = (places[from] - places[to]).norm();
      for (const std::size_t vertex : {from, to}) {
        sum_m[vertex] += weight * length_m;
        edges[vertex] += weight;
      }
    }
  }
  for (std::size_t p = 0; p < places.size(); ++p) sum_m[p] /= std::max(edges[p], 1.0);
  return sum_m;
}

/// Per point: whether it or one of its natural neighbours is on the hull.
std::vector<bool> on_rim(const DelaunayGraph& graph) {
  std::vector<bool> rim(graph.vertices.size(), false);
  for (const DelaunayTriangle& triangle : graph.triangles) {
    for (const std::int32_t corner : triangle.vertices) {
      if (graph.on_hull[static_cast<std::size_t>(corner)] == 0) continue;
      for (const std::int32_t v : triangle.vertices) rim[static_cast<std::size_t>(v)] = true;
    }
  }
  return rim;
}

}  // namespace

NaturalNeighbours natural_neighbours(std::span<const Eigen::Vector3d> points_m) {
  std::vector<Eigen::Vector2d> places;
  std::vector<std::size_t> index;
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    if (!points_m[k].allFinite()) continue;
    places.emplace_back(points_m[k].head<2>());
    index.push_back(k);
  }
  const DelaunayGraph graph = build_delaunay(places);
  const std::vector<double> length_m = mean_edge_lengths_m(graph);
  const std::vector<bool> rim = on_rim(graph);
  NaturalNeighbours around{std::vector<double>(points_m.size(), 0.0),
                           std::vector<bool>(points_m.size(), true)};
  for (std::size_t k = 0; k < index.size(); ++k) {
    around.distance_m[index[k]] = length_m[k];
    around.on_rim[index[k]] = rim[k];
  }
  return around;
}

double mean_neighbour_distance_m(std::span<const Eigen::Vector3d> points_m, Periphery periphery) {
  const NaturalNeighbours around = natural_neighbours(points_m);
  // Nevalainen2021 Eq. (23)
  std::array<double, 2> sum_m{}, count{};  // of the inner points, of all
  for (std::size_t k = 0; k < points_m.size(); ++k) {
    if (around.distance_m[k] == 0.0) continue;
    for (const std::size_t kind : {0U, 1U}) {
      if (kind == 0 && around.on_rim[k]) continue;
      sum_m[kind] += around.distance_m[k];
      count[kind] += 1.0;
    }
  }
  const std::size_t kind = periphery == Periphery::kLeftOut && count[0] > 0.0 ? 0 : 1;
  return count[kind] == 0.0 ? 0.0 : sum_m[kind] / count[kind];
}

ConvergenceLimits convergence_limits(double mean_neighbour_distance_m, double outlier_ratio,
                                     double range_m, double tilt_deg) {
  HONKA_CHECK(outlier_ratio < 1.0 && range_m > 0.0, "limits need inliers and a range");
  ConvergenceLimits limits;
  // Nevalainen2021 Eq. (24), Nevalainen2021 Eq. (25)
  limits.translation_m = 0.5 * mean_neighbour_distance_m;
  limits.rotation_rad = limits.translation_m / (std::sqrt(1.0 - outlier_ratio) * range_m);
  limits.tilt_rad = deg_to_rad(tilt_deg);
  return limits;
}

Eigen::Vector2d turn_and_tilt(const Eigen::Matrix3d& rotation) {
  const double turn = std::atan2(rotation(1, 0) - rotation(0, 1), rotation(0, 0) + rotation(1, 1));
  const double tilt = std::atan2(rotation.col(2).head<2>().norm(), rotation(2, 2));
  return {std::abs(turn), tilt};
}

double convergence_measure(const Pose3& mismatch, const ConvergenceLimits& limits) {
  const Eigen::Vector2d turned = turn_and_tilt(mismatch.linear());
  // Nevalainen2021 Eq. (26)
  return std::pow(mismatch.translation().norm() / limits.translation_m, 2) +
         std::pow(turned.x() / limits.rotation_rad, 2) + std::pow(turned.y() / limits.tilt_rad, 2);
}

}  // namespace honka
