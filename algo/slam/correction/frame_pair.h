#pragma once

#include <cstdint>

#include "algo/types/pose.h"

namespace honka {

/// Two frames of a map that a correction may tie: i after j, by their positions in the chain.
struct FramePair {
  std::uint32_t j = 0, i = 0;
  double overlap = 0.0;  ///< λ of their view cones
  double error_m = 0.0;  ///< e of the match in their common view

  [[nodiscard]] std::uint32_t gap() const { return i - j; }
};

}  // namespace honka
