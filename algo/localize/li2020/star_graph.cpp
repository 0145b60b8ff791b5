#include "algo/localize/li2020/star_graph.h"

#include <Eigen/Geometry>
#include <cmath>

#include "algo/localize/matcher.h"

namespace honka {
namespace {

/// Whole metres near the middle.
template <int D>
StarPoint<D> middle_of(const StarPoints<D>& points) {
  if (points.empty()) return StarPoint<D>::Zero();
  StarPoint<D> low = points[0];
  StarPoint<D> high = points[0];
  for (const StarPoint<D>& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const StarPoint<D> middle = (0.5 * (low + high)).array().round();
  return middle.allFinite() ? middle : StarPoint<D>(StarPoint<D>::Zero());
}

DelaunayGraph measured_delaunay(const StarPoints<2>& stems_m) { return build_delaunay(stems_m); }

DelaunayGraph measured_delaunay(const StarPoints<3>& stems_m) {
  DelaunayGraph graph = build_delaunay(plan_of(stems_m));
  measure_in_space(graph, stems_m);
  return graph;
}

}  // namespace

void measure_in_space(DelaunayGraph& graph, const StarPoints<3>& corners_m) {
  for (DelaunayTriangle& triangle : graph.triangles) {
    const auto corner = [&](std::size_t k) -> const Eigen::Vector3d& {
      return corners_m[static_cast<std::size_t>(triangle.vertices[k])];
    };
    // Li2020 Eq. (1), A and L of corners with heights
    const Eigen::Vector3d ab = corner(1) - corner(0);
    const Eigen::Vector3d ac = corner(2) - corner(0);
    const double perimeter = ab.norm() + ac.norm() + (ac - ab).norm();
    triangle.area_m2 = 0.5 * ab.cross(ac).norm();
    triangle.perimeter_squared_m2 = perimeter * perimeter;
  }
}

template <int D>
StarGraph<D> star_graph(const StarPoints<D>& stems_m) {
  StarGraph<D> graph;
  graph.delaunay = measured_delaunay(stems_m);
  graph.centre_m = middle_of<D>(stems_m);
  graph.vertices_m = stems_m;
  for (StarPoint<D>& vertex : graph.vertices_m) vertex -= graph.centre_m;
  for (Eigen::Vector2d& vertex : graph.delaunay.vertices) {
    vertex -= graph.centre_m.template head<2>();
  }
  return graph;
}

template StarGraph<2> star_graph(const StarPoints<2>&);
template StarGraph<3> star_graph(const StarPoints<3>&);

}  // namespace honka
