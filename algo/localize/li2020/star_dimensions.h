#pragma once

#include <Eigen/Core>
#include <array>
#include <type_traits>
#include <vector>

#include "algo/types/pose.h"

namespace honka {

// Stars lie in the plane (D = 2), as the paper has them, or in space (D = 3), its future work.

template <int D>
using StarPoint = Eigen::Matrix<double, D, 1>;
template <int D>
using StarPoints = std::vector<StarPoint<D>>;
/// The vertices of one star: three corners, three apexes.
template <int D>
using StarVertices = std::array<StarPoint<D>, 6>;

/// A rigid motion of such points.
template <int D>
using StarTransform = std::conditional_t<D == 2, Pose2, Pose3>;

template <int D>
[[nodiscard]] StarTransform<D> no_motion() {
  if constexpr (D == 2) {
    return Pose2{};
  } else {
    return Pose3::Identity();
  }
}

}  // namespace honka
