#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>
#include <vector>

#include "algo/types/stem.h"
#include "eval/config/scenario.h"
#include "eval/run/trunk_map.h"
#include "sim/forest/stand.h"

namespace honka::eval {

/// Whether a map source lists the trees of a stand, in place of what a run saw.
[[nodiscard]] bool lists_trees(std::string_view map_source);

/// The stem map of map.source = inventory | airborne of a stand, in the world frame. The digits
/// depend on (tree, seed). UserError at a source that is a run.
[[nodiscard]] StemMap source_map(const sim::Stand& stand, const Scenario& scenario,
                                 std::uint64_t seed);

/// Where the stems of a list stand.
[[nodiscard]] std::vector<Eigen::Vector2d> places_of(const StemMap& stems);

/// The same as a trunk map, its settings telling whether it counts as the repaired form's.
[[nodiscard]] TrunkMap listed_trunk_map(const Scenario& scenario, const sim::Stand& stand,
                                        const StemSettings& settings, std::uint64_t seed);

}  // namespace honka::eval
