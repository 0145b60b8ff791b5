#pragma once

#include <array>
#include <cstdint>

#include "algo/localize/li2020/star.h"
#include "algo/localize/li2020/star_dimensions.h"
#include "algo/localize/matcher.h"

namespace honka {

/// How the corners of two alike triangles are paired.
enum class Pairing : std::uint8_t {
  kSimilarEdge,   ///< literal: the closest of the nine pairs of sides, then Eq. (2)
  kLeastSideSum,  ///< variant: the rotation with the least sum of side differences
};

/// Vertex pairs of two stars: three corners, then the apexes of the neighbours that correspond.
/// Li2020 Eq. (2). Only differences of coordinates enter. In space sides have their length there;
/// on which side a corner lies is asked in the plan of each list, as its triangles are.
template <int D>
[[nodiscard]] std::array<VertexPair, 6> pair_vertices(const TriangleStar& local,
                                                      const StarPoints<D>& in_local_m,
                                                      const TriangleStar& map,
                                                      const StarPoints<D>& in_map_m,
                                                      Pairing pairing);

}  // namespace honka
