#include "algo/slam/correction/candidate_pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_set>

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka {
namespace {

/// Gaps from here on are looked at: neighbours are the chain's own pairs.
constexpr std::int64_t kSmallestGap = 2;

/// A random pair, all pairs of an allowed gap equally likely.
FramePair random_pair(std::uint64_t seed, std::uint64_t number, std::int64_t frames,
                      std::int64_t max_gap) {
  RandomStream random(seed, "candidate_pair", {number});
  const auto gaps = static_cast<std::uint64_t>(std::min(max_gap, frames - 1) - kSmallestGap + 1);
  for (;;) {
    const auto gap = static_cast<std::int64_t>(random.below(gaps)) + kSmallestGap;
    const auto j = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(frames)));
    if (j + gap >= frames) continue;
    FramePair pair;
    pair.j = static_cast<std::uint32_t>(j);
    pair.i = static_cast<std::uint32_t>(j + gap);
    return pair;
  }
}

std::vector<std::uint8_t> registrable_frames(std::span<const SparseFrame> frames) {
  std::vector<std::uint8_t> usable;
  usable.reserve(frames.size());
  for (const SparseFrame& frame : frames) {
    usable.push_back(registrable(frame.points_m) == RegistrationStatus::kRegistered ? 1 : 0);
  }
  return usable;
}

/// λ and e of a pair: at the map's own poses (A), or where an ICP from there ends (B).
class PairJudge {
 public:
  PairJudge(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
            const ViewCone& cone, const MatchQualitySettings& quality,
            const TrimmedIcpSettings& icp, bool by_icp)
      : frames_(frames),
        T_first_frame_(T_first_frame),
        cone_(cone),
        overlap_(cone),
        quality_(quality),
        icp_(icp),
        by_icp_(by_icp) {}

  /// The pair judged; nothing where λ is not above the limit or the ICP gave no pose.
  [[nodiscard]] std::optional<FramePair> operator()(FramePair pair, double overlap_limit) const {
    const auto& target_m = frames_[pair.j].points_m;
    const auto& source_m = frames_[pair.i].points_m;
    Pose3 T_j_i = T_first_frame_[pair.j].inverse() * T_first_frame_[pair.i];
    pair.overlap = overlap_of(T_j_i);
    if (pair.overlap <= overlap_limit) return std::nullopt;
    if (by_icp_) {
      const Registration match = trimmed_icp(target_m, source_m, T_j_i, icp_);
      if (!match.usable()) return std::nullopt;
      T_j_i = match.T_target_source;
      pair.overlap = overlap_of(T_j_i);
      if (pair.overlap <= overlap_limit) return std::nullopt;
    }
    const MatchQuality match = judge_match(target_m, source_m, T_j_i, cone_, quality_);
    if (!std::isfinite(match.error_m)) return std::nullopt;
    pair.error_m = match.error_m;
    return pair;
  }

 private:
  /// Cones whose tips are two ranges apart share nothing.
  [[nodiscard]] double overlap_of(const Pose3& T_j_i) const {
    if (T_j_i.translation().head<2>().norm() >= 2.0 * cone_.range_m) return 0.0;
    return overlap_(T_j_i);
  }

  std::span<const SparseFrame> frames_;
  const FramePoses& T_first_frame_;
  const ViewCone& cone_;
  ViewOverlap overlap_;
  const MatchQualitySettings& quality_;
  const TrimmedIcpSettings& icp_;
  bool by_icp_;
};

}  // namespace

void describe(SettingsVisitor& v, CandidatePairSettings& s) {
  v.field({"overlap_limit", "", "λ of two view cones that a candidate pair must exceed",
           "Nevalainen2021 §2.4: 0.2; §2.3: 0.4"},
          s.overlap_limit, Range{0.0, 1.0});
  v.field({"max_gap", "", "largest number of frames between a pair", "Nevalainen2021 §2.4"},
          s.max_gap, Range{1.0, 1e9});
  v.field({"tries", "", "random pairs looked at, at most",
           "choice; Nevalainen2021 §2.4 looked at 1,870,000"},
          s.tries, Range{0.0, 1e9});
  v.field({"wanted", "", "pairs found that end the search", "Nevalainen2021 §2.4: 3,500"}, s.wanted,
          Range{0.0, 1e9});
  v.field({"test", "", "errors by the nearest neighbours as they lie, or after an ICP attempt",
           "Nevalainen2021 §2.4: nearest; Fig. 9: icp"},
          s.test, {"nearest", "icp"});
  v.field(
      {"error_at_no_overlap_m", "m", "largest e of a match at λ = 0", "Nevalainen2021 Eq. (27)"},
      s.error_at_no_overlap_m, Range{0.0, 100.0});
  v.field({"error_slope_m", "m", "by which it grows up to λ = 1", "Nevalainen2021 Eq. (27)"},
          s.error_slope_m, Range{0.0, 100.0});
}

CandidatePairs find_candidate_pairs(std::span<const SparseFrame> frames,
                                    const FramePoses& T_first_frame, const ViewCone& cone,
                                    const MatchQualitySettings& quality,
                                    const TrimmedIcpSettings& icp,
                                    const CandidatePairSettings& settings, std::uint64_t seed) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  CandidatePairs found;
  const auto count = static_cast<std::int64_t>(frames.size());
  if (count <= kSmallestGap || settings.max_gap < kSmallestGap) return found;
  const auto usable = registrable_frames(frames);
  const PairJudge judge(frames, T_first_frame, cone, quality, icp, settings.test == "icp");
  std::unordered_set<std::uint64_t> seen;
  while (found.tried < settings.tries &&
         static_cast<std::int64_t>(found.promising.size()) < settings.wanted) {
    const FramePair pair =
        random_pair(seed, static_cast<std::uint64_t>(found.tried), count, settings.max_gap);
    ++found.tried;
    if (usable[pair.j] == 0 || usable[pair.i] == 0) continue;
    if (!seen.insert((std::uint64_t{pair.j} << 32U) | pair.i).second) continue;
    const auto judged = judge(pair, settings.overlap_limit);
    if (!judged) continue;
    // Nevalainen2021 Eq. (27)
    const bool promising = judged->error_m < settings.error_limit_m(judged->overlap);
    (promising ? found.promising : found.inferior).push_back(*judged);
  }
  return found;
}

}  // namespace honka
