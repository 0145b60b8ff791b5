#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/correction/frame_pair.h"

namespace honka {

/// A sample of pairs that covers the (j, i) plane evenly.
struct PoissonChoice {
  std::vector<std::size_t> chosen;  ///< I: indices into the pairs, rising, none twice
  std::int64_t grid_points = 0;     ///< |I1|
  double spacing = 0.0;             ///< ε of the grid, in frames
};

/// Steps 2 and 3 of the selection: the pairs are rounded to a grid of spacing ε, which starts at
/// √(bounding box of the pairs / m) and shrinks by 0.8 while the number of grid points comes nearer
/// to `wanted` = m; each occupied grid point then takes the pair nearest to it (the first of
/// equally near ones). No pairs or wanted < 1 give none. Source: Nevalainen2021 Eqs. 28–29.
[[nodiscard]] PoissonChoice choose_near_poisson(std::span<const FramePair> pairs,
                                                std::int64_t wanted);

}  // namespace honka
