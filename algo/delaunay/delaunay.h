#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace honka {

/// A triangle of a Delaunay graph, with the two numbers that Li2020 compares.
struct DelaunayTriangle {
  std::array<std::int32_t, 3> vertices{};  ///< counter-clockwise, input indices
  std::array<std::int32_t, 3> neighbours{-1, -1,
                                         -1};  ///< across the edge opposite vertex k; -1 none
  double area_m2 = 0.0;
  double perimeter_squared_m2 = 0.0;
};

/// The Delaunay triangulation of points in the plane.
struct DelaunayGraph {
  std::vector<Eigen::Vector2d> vertices;  ///< the input points, in input order
  std::vector<DelaunayTriangle>
      triangles;                      ///< in the lexicographic order of their vertices' places
  std::vector<std::uint8_t> on_hull;  ///< per vertex: 1 on the boundary of the convex hull
};

/// Delaunay triangulation of N points (metres, any frame), with exact predicates.
///
/// Points at one and the same place are merged: triangles name the lowest input index, the others
/// share its hull flag. Fewer than three places, or places on one line, give no triangles, and
/// every vertex is then on the hull. Triangles, their order and their first vertices depend on the
/// places alone, so any order of the input gives the same triangles in the same order, cocircular
/// points (planted grids) included. Throws UserError at a coordinate that is not finite.
/// Source: Li2020 §2.8.
[[nodiscard]] DelaunayGraph build_delaunay(const std::vector<Eigen::Vector2d>& points_m);

}  // namespace honka
