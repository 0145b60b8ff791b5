#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace honka {

/// Two ways to the same answer: a k-d tree, or a hash of cells with exact distance tests.
enum class NeighbourSearch : std::uint8_t { kKdTree, kVoxelHash };

/// For each point 1 when any point lies within `radius_m` (d < radius) of the spot `offset_m`
/// above it, else 0.
[[nodiscard]] std::vector<std::uint8_t> has_neighbour_above(
    std::span<const Eigen::Vector3d> points_m, double offset_m, double radius_m,
    NeighbourSearch search);

/// For each point 1 when another point lies within `radius_m` of it in the plane, else 0.
[[nodiscard]] std::vector<std::uint8_t> has_other_within(std::span<const Eigen::Vector2d> points_m,
                                                         double radius_m, NeighbourSearch search);

/// Euclidean clusters (Rusu 2009): two points nearer than `link_m` share a cluster. Returns for
/// each point the lowest index in its cluster. Dim 2 or 3.
template <int Dim>
[[nodiscard]] std::vector<std::uint32_t> euclidean_clusters(
    std::span<const Eigen::Matrix<double, Dim, 1>> points_m, double link_m, NeighbourSearch search);

}  // namespace honka
