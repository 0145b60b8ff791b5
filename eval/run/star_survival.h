#pragma once

#include "algo/delaunay/delaunay.h"
#include "algo/types/pose.h"

namespace honka::eval {

/// Local stars that could be matched at all: how many there are, and how many stand unchanged in
/// the map's graph.
struct StarSurvival {
  int stars = 0;      ///< interior local triangles (Li2020, 2.8)
  int surviving = 0;  ///< whose centre and three neighbours are triangles of the map too
};

/// Follows each local vertex to the map stem nearest to its true place (within `gate_m`).
/// `T_map_local` is truth: for reports, never for an algorithm.
[[nodiscard]] StarSurvival star_survival(const DelaunayGraph& local, const DelaunayGraph& map,
                                         const Pose2& T_map_local, double gate_m);

}  // namespace honka::eval
