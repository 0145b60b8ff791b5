#pragma once

#include <cstddef>

namespace honka::sim {

/// What building the hierarchy over a world took.
struct BuildStatistics {
  double seconds = 0.0;
  std::size_t bytes = 0;       ///< of the hierarchy and the geometry that it points to
  std::size_t primitives = 0;  ///< cone pieces, ellipsoids and triangles
};

}  // namespace honka::sim
