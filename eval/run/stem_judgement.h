#pragma once

#include <array>

#include "algo/types/stem.h"
#include "eval/metrics/stem_scores.h"
#include "eval/run/drive.h"
#include "eval/run/trunk_map.h"

namespace honka::eval {

/// Edges of the range bins of stem detection. Metres.
inline constexpr std::array<double, 5> kStemRanges_m = {0.0, 10.0, 20.0, 30.0, 40.0};

/// Scores the stems of a window's cloud against the trees that stand inside the field of view and
/// the last range edge; a tree hidden by others counts as missed.
[[nodiscard]] StemScores score_window(const std::vector<ObservedStem>& stems_in_local,
                                      const StemMap& stems_in_world, const Pose2& T_world_local,
                                      double field_of_view_rad, double gate_m);

/// Scores a trunk map against the trees within `reach_m` of a key frame of the run that made it.
[[nodiscard]] StemScores score_map(const TrunkMap& map, const StemMap& stems_in_world,
                                   const Drive& run, double reach_m, double gate_m);

}  // namespace honka::eval
