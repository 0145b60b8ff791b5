#pragma once

#include <cstdint>
#include <vector>

#include "sim/sighting/mapped_forest.h"

namespace honka::sim {

/// What a stem detector lists at a pose.
struct Sighting {
  Points stems_in_sensor_m;         ///< by distance of their true place, then the false ones
  std::vector<std::int32_t> trees;  ///< of each: index into the forest's trees, −1 for none
};

/// The list at `T_world_sensor`, without rays: standing trees in range and view, each missed or
/// not, the nearest of them, with noise and bias; then false stems, uniform over that part of the
/// view that the list reaches. The digits depend on (seed, query) and the arguments alone.
[[nodiscard]] Sighting sight(const MappedForest& forest, const Pose2& T_world_sensor,
                             const SightingSettings& settings, std::uint64_t seed,
                             std::uint64_t query);

}  // namespace honka::sim
