#pragma once

#include <optional>

#include "algo/types/stem.h"
#include "eval/run/trunk_map.h"

namespace honka::eval {

/// How a trunk map lies on the world about a place: T_map_world, the rigid fit of the trees within
/// 50 m to their stems in the map. The odometry of the mapping run bends a map slowly; a matcher
/// can find a place in the map as it is, no better. Nothing with fewer than ten pairs within the
/// gate.
[[nodiscard]] std::optional<Pose2> map_bend(const TrunkMap& map, const StemMap& stems_in_world,
                                            const Eigen::Vector2d& place_in_world_m, double gate_m);

}  // namespace honka::eval
