#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/match_quality.h"
#include "algo/slam/methods/pair_match.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// Which pairs of frames are matched, and when a match counts.
struct VerifiedPairsSettings {
  std::vector<std::int64_t> gaps = {64, 256};  ///< scales, in frames
  double share_of_frames = 0.04;               ///< at most this many matches a frame
  double min_overlap = 0.35;                   ///< λ by the current poses
  double inlier_ratio = 0.4;                   ///< of the trimmed ICP
  double polish_distance_m = 0.4;              ///< as in the chain
  double min_match_share = 0.33;               ///< share test of a match
  bool global_where_refused = true;   ///< a global registration where ICP fails the share test
  bool propose_by_landmarks = false;  ///< also pairs that only landmark matching finds
  std::int64_t proposal_step = 100;   ///< frames between those that look for each other
};
void describe(SettingsVisitor& v, VerifiedPairsSettings& s);

/// Verified matches and what finding them took.
struct VerifiedPairs {
  std::vector<PairMatch> matches;  ///< in rising order of the later frame, then of the earlier
  std::size_t tried = 0;           ///< pairs whose views overlap enough
  std::size_t icp_calls = 0, global_calls = 0;
  std::size_t proposed = 0;  ///< of the matches, those only landmark matching found
};

/// Matches frames `gap` apart at each scale, guesses from the current poses, and keeps what passes
/// the share test. Frames must be finite. Source: choice, beyond Nevalainen2021.
[[nodiscard]] VerifiedPairs find_verified_pairs(std::span<const SparseFrame> frames,
                                                const FramePoses& T_first_frame,
                                                const ViewCone& cone,
                                                const MatchQualitySettings& quality,
                                                const VerifiedPairsSettings& settings);

}  // namespace honka
