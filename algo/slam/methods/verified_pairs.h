#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/match_quality.h"
#include "algo/slam/methods/pair_match.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// Which pairs of frames are matched, and when a match counts.
struct VerifiedPairsSettings {
  std::vector<std::int64_t> gaps = {64, 256, 1024};  ///< scales, in frames
  double share_of_frames = 0.04;      ///< so many pairs a frame, and at most one more a scale
  double min_overlap = 0.35;          ///< λ by the current poses
  double inlier_ratio = 0.4;          ///< of the trimmed ICP
  double polish_distance_m = 0.4;     ///< as in the chain
  double min_match_share = 0.33;      ///< of the common view's points with a partner
  std::string global = "landmarks";   ///< landmarks | go_icp | none: where ICP is refused
  bool propose = false;               ///< also look for pairs that the poses do not show
  std::int64_t proposal_step = 64;    ///< frames between those that look for each other
  std::int64_t proposal_points = 25;  ///< in the common view of a proposed match
  double proposal_share = 0.5;        ///< and how many of them need a partner
};
void describe(SettingsVisitor& v, VerifiedPairsSettings& s);

/// Verified matches, and what finding them took.
struct VerifiedPairs {
  std::vector<PairMatch> matches;  ///< finest scale first, then by frames; proposals at the end
  std::size_t tried = 0;           ///< pairs whose views overlap enough
  std::size_t icp_calls = 0, global_calls = 0;
  std::size_t proposed = 0;  ///< of the matches, those that landmark matching alone found
};

/// Matches frames `gap` apart at each scale, the finest first: each scale's matches squeeze the
/// poses that the next one guesses and reckons overlaps from. Keeps what passes the share test.
/// With `propose` every `proposal_step`-th frame also looks for every other one by landmark
/// matching: closures that do not trust the chain. Frames must be finite, one pose a frame.
/// Source: choice, beyond Nevalainen2021.
[[nodiscard]] VerifiedPairs find_verified_pairs(std::span<const SparseFrame> frames,
                                                const FramePoses& T_first_frame,
                                                const ViewCone& cone,
                                                const MatchQualitySettings& quality,
                                                const VerifiedPairsSettings& settings);

/// Matches of `sources` with `targets` (positions in the list of frames) by landmark matching
/// alone; each with each, verified more strictly than where a guess exists.
[[nodiscard]] VerifiedPairs propose_pairs(std::span<const SparseFrame> frames,
                                          std::span<const std::size_t> targets,
                                          std::span<const std::size_t> sources,
                                          const ViewCone& cone, const MatchQualitySettings& quality,
                                          const VerifiedPairsSettings& settings);

}  // namespace honka
