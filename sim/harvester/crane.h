#pragma once

#include <cstdint>
#include <vector>

#include "sim/harvester/vehicle_settings.h"
#include "sim/harvester/work_plan.h"
#include "sim/world/world.h"

namespace honka::sim {

/// The crane and, while processing, the tree in its head, in the frame of the front body: origin on
/// the ground under the joint, x ahead, y left, z up.
[[nodiscard]] std::vector<Cone> crane_in_body(const Phase& phase, double time_s,
                                              const VehicleSettings& settings, std::uint64_t seed);

}  // namespace honka::sim
