#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace honka {

/// A stem and three others counter-clockwise around it, from a first one on.
using StemGroup = std::array<std::uint32_t, 4>;

/// The distances that tell groups apart: base to each other stem, first to
/// second, second to third. Five numbers are the shape of four stems in the
/// plane, up to mirrored parts.
struct GroupShape {
  std::array<double, 3> legs_m{};
  std::array<double, 2> sides_m{};
};

[[nodiscard]] inline GroupShape shape_of(std::span<const Eigen::Vector2d> stems_m,
                                         const StemGroup& g) {
  const auto distance = [&](std::size_t a, std::size_t b) {
    return (stems_m[g[a]] - stems_m[g[b]]).norm();
  };
  return {{distance(0, 1), distance(0, 2), distance(0, 3)}, {distance(1, 2), distance(2, 3)}};
}

/// The same group from another of its stems on.
[[nodiscard]] inline StemGroup turned(const StemGroup& g, std::size_t by) {
  return {g[0], g[1 + by % 3], g[1 + (by + 1) % 3], g[1 + (by + 2) % 3]};
}

/// Sorts stems around a base counter-clockwise, by their direction from −π.
void sort_around(std::span<const Eigen::Vector2d> stems_m, std::uint32_t base,
                 std::span<std::uint32_t> others);

}  // namespace honka
