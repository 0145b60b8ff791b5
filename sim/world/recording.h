#pragma once

#include <cstdint>
#include <vector>

#include "algo/types/sweep.h"
#include "sim/world/world.h"

namespace honka::sim {

/// Truth of one return, beside Sweep::returns at the same index.
struct ReturnTruth {
  Label label;           ///< part kNone for a miss
  float range_m = 0.0F;  ///< exact range of the centre ray's surface, without noise; 0 for a miss
};

/// A sweep and, apart from it, its truth.
struct TruthfulSweep {
  Sweep sweep;
  std::vector<ReturnTruth> truth;
};

}  // namespace honka::sim
