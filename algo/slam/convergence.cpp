#include "algo/slam/convergence.h"

#include <algorithm>
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

double mean_neighbour_distance_m(std::span<const Eigen::Vector3d> points_m, Periphery periphery) {
  std::vector<Eigen::Vector2d> places;
  places.reserve(points_m.size());
  for (const Eigen::Vector3d& p : points_m) {
    if (p.allFinite()) places.emplace_back(p.head<2>());
  }
  const DelaunayGraph graph = build_delaunay(places);
  const std::vector<double> length_m = mean_edge_lengths_m(graph);
  const std::vector<bool> rim = on_rim(graph);
  // Nevalainen2021 Eq. (23)
  double sum_m = 0.0, counted = 0.0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (length_m[p] == 0.0 || (periphery == Periphery::kLeftOut && rim[p])) continue;
    sum_m += length_m[p];
    counted += 1.0;
  }
  if (counted > 0.0) return sum_m / counted;
  return periphery == Periphery::kLeftOut ? mean_neighbour_distance_m(points_m, Periphery::kCounted)
                                          : 0.0;
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
