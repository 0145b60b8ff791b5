#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "algo/localize/consensus/allowed.h"
#include "algo/localize/consensus/frame.h"
#include "algo/localize/consensus/judge.h"
#include "algo/localize/consensus/places.h"

namespace honka {

/// Counts, for every turn and shift of the frame, the stems that fall on stems,
/// and refines the highest counts. Complete whatever is missed, false or noisy,
/// but its cost grows with the map: it is left out where it would need more
/// than `exhaustive_votes`. `map_m`: the stems that a prior leaves, or all.
/// Returns the number of places that were refined.
std::int64_t search_exhaustively(const Judge& judge, const LocalFrame& frame,
                                 const std::vector<Eigen::Vector2d>& map_m, const Allowed& allows,
                                 PlaceList& places);

}  // namespace honka
