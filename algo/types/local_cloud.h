#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace honka {

/// Points of one or more key frames in one common frame, with the place each was seen from.
struct LocalCloud {
  std::vector<Eigen::Vector3d> points_m;   ///< N points
  std::vector<std::uint32_t> frames;       ///< N indices into origins_m
  std::vector<Eigen::Vector3d> origins_m;  ///< sensor position of each key frame
  [[nodiscard]] std::size_t size() const { return points_m.size(); }
};

}  // namespace honka
