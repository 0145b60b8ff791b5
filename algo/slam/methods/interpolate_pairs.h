#pragma once

#include <span>
#include <string>

#include "algo/slam/methods/pair_match.h"
#include "algo/slam/sparse_frame.h"
#include "algo/types/settings.h"

namespace honka {

/// How verified matches are put into the chain by interpolation.
struct InterpolatePairsSettings {
  std::string side = "left";               ///< right: Eq. (19); left: the form without its defect
  std::string order = "small_gaps_first";  ///< small_gaps_first | medium_gaps_first | random
};
void describe(SettingsVisitor& v, InterpolatePairsSettings& s);

/// The edge's cheap update: each match squeezes the frames between its two (Nevalainen2021
/// Eqs. 19–21), one after the other. A match that names a frame that is not there is left out.
[[nodiscard]] FramePoses interpolate_pairs(const FramePoses& T_first_frame,
                                           std::span<const PairMatch> matches,
                                           const InterpolatePairsSettings& settings);

}  // namespace honka
