#pragma once

#include "algo/delaunay/delaunay.h"
#include "algo/localize/li2020/star_dimensions.h"

namespace honka {

/// The Delaunay graph of N stems, its vertices about their middle.
template <int D>
struct StarGraph {
  /// Triangles of the plan x, y of the list; their areas and perimeters are those of the corners in
  /// D dimensions. Vertices relative to `centre_m`.
  DelaunayGraph delaunay;
  StarPoints<D> vertices_m;  ///< relative to `centre_m`, in the order of the stems
  StarPoint<D> centre_m = StarPoint<D>::Zero();  ///< whole metres near the middle
};

/// UserError at a coordinate that is not finite. Which stems are neighbours is asked in the plan of
/// the list, its frame's x and y: a list of a sensor tilted by θ lies stretched by 1/cos θ there
/// along the slope, and triangles near a change of neighbours are then others than the map's.
template <int D>
[[nodiscard]] StarGraph<D> star_graph(const StarPoints<D>& stems_m);

/// Areas and perimeters of the triangles from corners in space, in place of those in plan.
void measure_in_space(DelaunayGraph& graph, const StarPoints<3>& corners_m);

}  // namespace honka
