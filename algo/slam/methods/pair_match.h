#pragma once

#include <cstddef>

#include "algo/types/pose.h"

namespace honka {

/// Two frames far apart in the sequence, matched and verified: a corrective match.
struct PairMatch {
  std::size_t earlier = 0, later = 0;  ///< positions in the list of frames, earlier < later
  Pose3 T_earlier_later = Pose3::Identity();
  double error_m = 0.0;  ///< e of the match
  double share = 0.0;    ///< of the common view's points with a partner
};

}  // namespace honka
