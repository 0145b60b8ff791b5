#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algo/delaunay/delaunay.h"

namespace honka {

/// A triangle and its three neighbours; neighbour k lies across the edge opposite corner k.
struct TriangleStar {
  std::int32_t triangle = -1;              ///< the centre, index into the graph
  std::array<std::int32_t, 6> vertices{};  ///< corners 0–2 counter-clockwise, apexes of neighbours
  std::array<double, 4> area_m2{};         ///< A0 … A3 of Li2020 Eq. (1); 0 is the centre
  std::array<double, 4> perimeter_squared_m2{};  ///< l0 … l3 of Li2020 Eq. (1)
};

/// Which triangles of a graph are the centre of a star.
enum class StarChoice : std::uint8_t {
  kThreeNeighbours,  ///< the map: any triangle with three neighbours
  kNoHullVertex,     ///< a local graph: triangles that touch no peripheral point
};

/// The stars of a graph, in the order of its triangles.
[[nodiscard]] std::vector<TriangleStar> stars_of(const DelaunayGraph& graph, StarChoice choice);

/// How alike two stars are at the best of the three rotations.
struct StarLikeness {
  int rotation = 0;               ///< local neighbour k against map neighbour (k + rotation) mod 3
  double dissimilarity_m2 = 0.0;  ///< |dA| + |dl| summed over centre and neighbours
};

/// d = |A' − A| + |l' − l| (Li2020 §2.8) of the centres of two stars, m².
[[nodiscard]] double centre_dissimilarity_m2(const TriangleStar& local, const TriangleStar& map);

/// The rotation of least total among those at which the centre and `neighbours_required` of the
/// neighbours are each within the tolerance; nothing when there is none. Six permutations would
/// admit mirror images.
[[nodiscard]] std::optional<StarLikeness> compare_stars(const TriangleStar& local,
                                                        const TriangleStar& map,
                                                        double tolerance_m2,
                                                        int neighbours_required);

}  // namespace honka
