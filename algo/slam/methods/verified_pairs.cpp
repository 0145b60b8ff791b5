#include "algo/slam/methods/verified_pairs.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "algo/slam/chain.h"
#include "algo/slam/methods/checked_match.h"
#include "algo/slam/methods/interpolate_pairs.h"
#include "algo/slam/registration/register.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// Branch and bound ends here, so that the answer depends on no clock.
constexpr std::int64_t kGlobalNodes = 20000;

using IndexPair = std::pair<std::size_t, std::size_t>;

/// Matches pairs of one list of frames.
class PairMatcher {
 public:
  PairMatcher(std::span<const SparseFrame> frames, const ViewCone& cone,
              const MatchQualitySettings& quality, const VerifiedPairsSettings& settings,
              VerifiedPairs& found)
      : frames_(frames),
        settings_(settings),
        rules_{settings.inlier_ratio, settings.polish_distance_m, settings.min_match_share, cone,
               quality},
        found_(found) {
    global_.go_icp.time_cap_s = 0.0;
    global_.go_icp.node_cap = kGlobalNodes;
  }

  /// ICP from the guess, and where it is refused a global registration. Keeps what passes.
  bool match(std::size_t earlier, std::size_t later, const Pose3& guess) {
    const MatchTarget target(frames_[earlier].points_m);
    const auto& source_m = frames_[later].points_m;
    if (!target.registrable() || registrable(source_m) != RegistrationStatus::kRegistered) {
      return false;
    }
    ++found_.icp_calls;
    CheckedMatch match = target.match(source_m, guess, rules_);
    if (!match.passed && settings_.global != "none") {
      match = globally(target, earlier, later, guess, settings_.global);
    }
    if (match.passed) keep(earlier, later, match);
    return match.passed;
  }

  /// A match without a guess, which has to pass a stricter test.
  bool propose(std::size_t earlier, std::size_t later) {
    const MatchTarget target(frames_[earlier].points_m);
    if (!target.registrable()) return false;
    const CheckedMatch match = globally(target, earlier, later, Pose3::Identity(), "landmarks");
    const bool sure = match.passed && match.quality.points >= settings_.proposal_points &&
                      match.quality.share >= settings_.proposal_share;
    if (sure) keep(earlier, later, match);
    return sure;
  }

 private:
  CheckedMatch globally(const MatchTarget& target, std::size_t earlier, std::size_t later,
                        const Pose3& guess, const std::string& method) {
    ++found_.global_calls;
    const Registration registration = register_clouds(
        frames_[earlier].points_m, frames_[later].points_m, method, global_, guess, rules_.cone);
    if (!registration.usable()) return {};
    return target.check(frames_[later].points_m, registration.T_target_source, rules_);
  }
  void keep(std::size_t earlier, std::size_t later, const CheckedMatch& match) {
    found_.matches.push_back(
        {earlier, later, match.T_target_source, match.quality.error_m, match.quality.share});
  }

  std::span<const SparseFrame> frames_;
  const VerifiedPairsSettings& settings_;
  MatchRules rules_;
  RegisterSettings global_;
  VerifiedPairs& found_;
};

/// Frames between the pairs of a scale: half a gap, and farther where all scales together would be
/// more than the settings allow.
double stretch_of(std::size_t frames, const VerifiedPairsSettings& s) {
  double pairs = 0.0;
  for (const std::int64_t gap : s.gaps) {
    const double room = static_cast<double>(frames) - static_cast<double>(gap);
    if (room > 0.0) pairs += 1.0 + std::floor(room / std::max(1.0, 0.5 * static_cast<double>(gap)));
  }
  const double most = std::max(1.0, s.share_of_frames * static_cast<double>(frames));
  return std::max(1.0, pairs / most);
}

std::vector<IndexPair> pairs_of_scale(std::size_t frames, std::int64_t gap, double stretch) {
  std::vector<IndexPair> pairs;
  const auto apart = static_cast<std::size_t>(gap);
  const double step = std::max(1.0, 0.5 * static_cast<double>(gap)) * stretch;
  for (std::size_t k = 0;; ++k) {
    const auto earlier = static_cast<std::size_t>(std::floor(static_cast<double>(k) * step));
    if (earlier + apart >= frames) break;
    pairs.emplace_back(earlier, earlier + apart);
  }
  return pairs;
}

/// Every n-th frame that could be matched, of at most `most`.
std::vector<std::size_t> lookouts(std::size_t frames, std::int64_t step) {
  constexpr std::size_t kMostLookouts = 64;  // their pairs grow with the square
  const std::size_t apart =
      std::max(static_cast<std::size_t>(step), (frames + kMostLookouts - 1) / kMostLookouts);
  std::vector<std::size_t> result;
  for (std::size_t l = 0; l < frames; l += std::max<std::size_t>(1, apart)) result.push_back(l);
  return result;
}

void append(VerifiedPairs& found, const VerifiedPairs& more) {
  std::set<IndexPair> known;
  for (const PairMatch& match : found.matches) known.emplace(match.earlier, match.later);
  for (const PairMatch& match : more.matches) {
    if (!known.emplace(match.earlier, match.later).second) continue;
    found.matches.push_back(match);
    ++found.proposed;
  }
  found.tried += more.tried;
  found.global_calls += more.global_calls;
}

}  // namespace

VerifiedPairs find_verified_pairs(std::span<const SparseFrame> frames,
                                  const FramePoses& T_first_frame, const ViewCone& cone,
                                  const MatchQualitySettings& quality,
                                  const VerifiedPairsSettings& settings) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  VerifiedPairs found;
  PairMatcher matcher(frames, cone, quality, settings, found);
  FramePoses poses = T_first_frame;
  const double stretch = stretch_of(frames.size(), settings);
  for (const std::int64_t gap : settings.gaps) {
    const std::size_t before = found.matches.size();
    for (const auto& [earlier, later] : pairs_of_scale(frames.size(), gap, stretch)) {
      const Pose3 guess = between(poses, earlier, later);
      if (view_overlap(planar(guess), cone) < settings.min_overlap) continue;
      ++found.tried;
      matcher.match(earlier, later, guess);
    }
    const auto fresh = std::span(found.matches).subspan(before);
    poses = interpolate_pairs(poses, fresh, {});
  }
  if (settings.propose) {
    const auto all = lookouts(frames.size(), settings.proposal_step);
    append(found, propose_pairs(frames, all, all, cone, quality, settings));
  }
  return found;
}

VerifiedPairs propose_pairs(std::span<const SparseFrame> frames,
                            std::span<const std::size_t> targets,
                            std::span<const std::size_t> sources, const ViewCone& cone,
                            const MatchQualitySettings& quality,
                            const VerifiedPairsSettings& settings) {
  VerifiedPairs found;
  PairMatcher matcher(frames, cone, quality, settings, found);
  for (const std::size_t target : targets) {
    for (const std::size_t source : sources) {
      if (target >= source) continue;
      ++found.tried;
      matcher.propose(target, source);
    }
  }
  found.proposed = found.matches.size();
  return found;
}

}  // namespace honka
