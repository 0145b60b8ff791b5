#pragma once

#include <cstdint>

#include "algo/localize/consensus/allowed.h"
#include "algo/localize/consensus/frame.h"
#include "algo/localize/consensus/judge.h"
#include "algo/localize/consensus/places.h"

namespace honka {

/// Proposes places from groups of four neighbouring stems, those around the
/// middle of the frame and of the nearest neighbours first. Stops once one
/// place is beyond doubt and a few more groups have been looked up, or with the
/// last group. Returns the number of map groups that were tried.
std::int64_t search_groups(const Judge& judge, const LocalFrame& frame, const Allowed& allows,
                           PlaceList& places);

}  // namespace honka
