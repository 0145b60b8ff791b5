#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "algo/localize/li2020/star.h"
#include "algo/localize/matcher.h"

namespace honka {

/// How the corners of two alike triangles are paired.
enum class Pairing : std::uint8_t {
  kSimilarEdge,   ///< literal: the closest of the nine pairs of sides, then Eq. (2)
  kLeastSideSum,  ///< variant: the rotation with the least sum of side differences
};

/// Vertex pairs of two stars: three corners, then the apexes of the neighbours that correspond.
/// Li2020 Eq. (2). Only differences of coordinates enter.
[[nodiscard]] std::array<VertexPair, 6> pair_vertices(
    const TriangleStar& local, const std::vector<Eigen::Vector2d>& in_local_m,
    const TriangleStar& map, const std::vector<Eigen::Vector2d>& in_map_m, Pairing pairing);

}  // namespace honka
