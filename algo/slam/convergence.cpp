#include "algo/slam/convergence.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "algo/delaunay/delaunay.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// An edge of a triangle seen from the triangle: k is opposite. Each inner edge is seen twice.
struct TriangleEdge {
  std::size_t from, to;
  bool on_hull;
};

TriangleEdge edge_opposite(const DelaunayTriangle& triangle, std::size_t k) {
  return {static_cast<std::size_t>(triangle.vertices[(k + 1) % 3]),
          static_cast<std::size_t>(triangle.vertices[(k + 2) % 3]), triangle.neighbours[k] < 0};
}

}  // namespace

double mean_neighbour_distance_m(std::span<const Eigen::Vector3d> points_m, HullEdges hull) {
  std::vector<Eigen::Vector2d> places;
  places.reserve(points_m.size());
  for (const Eigen::Vector3d& p : points_m) {
    if (p.allFinite()) places.emplace_back(p.head<2>());
  }
  const DelaunayGraph graph = build_delaunay(places);
  std::vector<double> sum_m(places.size(), 0.0), edges(places.size(), 0.0);
  for (const DelaunayTriangle& triangle : graph.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const TriangleEdge edge = edge_opposite(triangle, k);
      if (edge.on_hull && hull == HullEdges::kLeftOut) continue;
      const double weight = edge.on_hull ? 1.0 : 0.5;
      const double length_m = (places[edge.from] - places[edge.to]).norm();
      for (const std::size_t vertex : {edge.from, edge.to}) {
        sum_m[vertex] += weight * length_m;
        edges[vertex] += weight;
      }
    }
  }
  // Nevalainen2021 Eq. (23)
  double mean_sum_m = 0.0, counted = 0.0;
  for (std::size_t p = 0; p < places.size(); ++p) {
    if (edges[p] == 0.0) continue;
    mean_sum_m += sum_m[p] / edges[p];
    counted += 1.0;
  }
  return counted == 0.0 ? 0.0 : mean_sum_m / counted;
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
