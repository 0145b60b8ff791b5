#pragma once

#include <cstdint>

#include "sim/forest/stand.h"

namespace honka::sim {

/// Adds what stands and lies below the trees: bushes, saplings, rocks, stumps and logs.
void add_ground_surfaces(const Stand& stand, std::uint64_t seed, World& world);

}  // namespace honka::sim
