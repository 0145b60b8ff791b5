#pragma once

#include <cstdint>
#include <vector>

#include "algo/types/stem.h"
#include "sim/forest/settings.h"
#include "sim/forest/stand.h"
#include "sim/forest/thinning.h"

namespace honka::sim {

/// A stand on the site [0, width] × [0, length] with exactly density × area stems (margin
/// included), none of them nearer than the corridor's half-width to a corridor.
///
/// `measured` stems (at least 3, finite) are moved so that the middle of their window is the middle
/// of the site and keep their DBH and height; the forest around them has the density, DBH and
/// height curve that they have, and stands to them as to its own. They are the first trees of the
/// stand. UserError when the stems do not fit or the measured window is larger than the site.
[[nodiscard]] Stand make_stand(const ForestSettings& settings,
                               const std::vector<Polyline>& corridors, std::uint64_t seed,
                               const StemMap* measured = nullptr);

/// Every surface of the stand that a ray can hit; owners are Tree::id.
[[nodiscard]] World make_world(const Stand& stand, const ForestSettings& settings,
                               std::uint64_t seed);

}  // namespace honka::sim
