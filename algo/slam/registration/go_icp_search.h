#pragma once

#include <cstdint>
#include <vector>

#include "algo/slam/registration/go_icp_bounds.h"

namespace honka {

/// What ends a branch and bound.
struct SearchLimits {
  double gap_m = 0.05;        ///< boxes that cannot be better than the best by more are dropped
  MotionBox leaf;             ///< half widths of boxes that are not split further; 0: none
  double time_cap_s = 0.0;    ///< 0 is off
  std::int64_t node_cap = 0;  ///< 0 is off
};

/// What it found.
struct SearchResult {
  PlanarMotion best;
  double best_m = 0.0;   ///< objective there
  double lower_m = 0.0;  ///< no motion of the region is better than this
  std::int64_t nodes = 0;
  std::int64_t polishes = 0;  ///< runs of ICP
  int icp_steps = 0;
  bool capped = false;
};

/// Searches the boxes `region` for the least objective, beginning with `start` as the best. The box
/// of the least lower bound comes next, so that nothing is visited which a perfect guess would
/// spare. Boxes are cut across the dimension that moves the points most. A leaf is polished by ICP
/// and not cut; without leaves, the search goes on until best − lower ≤ gap.
[[nodiscard]] SearchResult branch_and_bound(TrimmedObjective& objective,
                                            const std::vector<MotionBox>& region,
                                            const PlanarMotion& start, const SearchLimits& limits);

}  // namespace honka
