#pragma once

#include "algo/localize/consensus/allowed.h"
#include "algo/localize/consensus/judge.h"
#include "algo/localize/consensus/places.h"

namespace honka {

/// Adds the places beside a fit that a planted stand would offer as well: moved
/// by the differences of neighbouring map stems.
void add_twins(const Judge& judge, const Fit& fit, const Allowed& allows, PlaceList& places);

}  // namespace honka
