#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/correction/frame_pair.h"
#include "algo/slam/match_quality.h"
#include "algo/slam/registration/trimmed_icp.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// How pairs of frames that overlap though far apart in time are found.
struct CandidatePairSettings {
  double overlap_limit = 0.2;          ///< λ must be above
  std::int64_t max_gap = 1000;         ///< largest i − j
  std::int64_t tries = 100000;         ///< random pairs looked at, at most
  std::int64_t wanted = 3500;          ///< pairs found that end the search
  std::string test = "nearest";        ///< nearest (variant A) | icp (variant B)
  double error_at_no_overlap_m = 0.3;  ///< Eq. 27: e < this + λ · slope
  double error_slope_m = 0.5;

  /// Eq. 27's right side.
  [[nodiscard]] double error_limit_m(double overlap) const {
    return error_at_no_overlap_m + error_slope_m * overlap;
  }
};
void describe(SettingsVisitor& v, CandidatePairSettings& s);

/// Every pair whose overlap and error were looked at, and what came of it.
struct CandidatePairs {
  std::vector<FramePair> promising;  ///< I2, in order of finding; no pair twice
  std::vector<FramePair> inferior;   ///< overlap enough, error above the line of Eq. 27
  std::int64_t tried = 0;            ///< random pairs, those without overlap included
};

/// Step 1 of the selection: random pairs (j, i), 1 < i − j <= max_gap, tested by λ of the view
/// cones and by e at the map's own poses (A) or after an ICP attempt from there (B). Frames that
/// cannot be judged give no pair. Source: Nevalainen2021 §2.4, Eq. 27.
[[nodiscard]] CandidatePairs find_candidate_pairs(
    std::span<const SparseFrame> frames, const FramePoses& T_first_frame, const ViewCone& cone,
    const MatchQualitySettings& quality, const TrimmedIcpSettings& icp,
    const CandidatePairSettings& settings, std::uint64_t seed);

}  // namespace honka
