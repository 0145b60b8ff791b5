#include "algo/slam/methods/checked_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algo/geometry/fit_pose.h"

namespace honka {
namespace {

/// Pairs change little after a trimmed fit; more rounds move a pose by under a millimetre.
constexpr int kPolishRounds = 3;
/// Pairs that fix a pose in space with some to spare.
constexpr std::size_t kPolishPairs = 5;

}  // namespace

MatchTarget::MatchTarget(std::span<const Eigen::Vector3d> points_m)
    : points_m_(points_m),
      search_(points_m),
      registrable_(honka::registrable(points_m) == RegistrationStatus::kRegistered) {}

Pose3 MatchTarget::polished(std::span<const Eigen::Vector3d> source_m, Pose3 pose,
                            double distance_m) const {
  std::vector<Eigen::Vector3d> target, source;
  for (int round = 0; round < kPolishRounds; ++round) {
    target.clear();
    source.clear();
    for (const Eigen::Vector3d& point : source_m) {
      const Eigen::Vector3d place_m = pose * point;
      const NearestStem found = search_.nearest_planar(place_m.head<2>());
      if (found.index < 0 || !(found.squared_m2 < distance_m * distance_m)) continue;
      target.push_back(points_m_[static_cast<std::size_t>(found.index)]);
      source.push_back(point);
    }
    if (source.size() < kPolishPairs) break;
    const Pose3 next = fit_pose(target, source, pose.linear());
    if (!next.matrix().allFinite()) break;
    pose = next;
  }
  return pose;
}

CheckedMatch MatchTarget::check(std::span<const Eigen::Vector3d> source_m,
                                const Pose3& T_target_source, const MatchRules& rules) const {
  CheckedMatch match;
  match.T_target_source = polished(source_m, T_target_source, rules.polish_distance_m);
  match.quality = judge_match(search_, source_m, match.T_target_source, rules.cone, rules.quality);
  match.passed = match.quality.share >= rules.min_share;
  return match;
}

CheckedMatch MatchTarget::match(std::span<const Eigen::Vector3d> source_m,
                                const Pose3& T_target_source_guess, const MatchRules& rules) const {
  TrimmedIcpSettings icp;
  icp.inlier_ratio = rules.inlier_ratio;
  CheckedMatch refused;
  refused.T_target_source = T_target_source_guess;
  if (!registrable_) return refused;
  const Registration found = trimmed_icp(search_, points_m_, source_m, T_target_source_guess, icp);
  if (!found.usable()) return refused;
  return check(source_m, found.T_target_source, rules);
}

double MatchTarget::trimmed_error_m(std::span<const Eigen::Vector3d> source_m,
                                    const Pose3& T_target_source, double inlier_ratio) const {
  if (source_m.empty() || points_m_.empty()) return std::numeric_limits<double>::infinity();
  std::vector<double> squared_m2;
  squared_m2.reserve(source_m.size());
  for (const Eigen::Vector3d& point : source_m) {
    const Eigen::Vector3d place_m = T_target_source * point;
    squared_m2.push_back(search_.nearest_planar(place_m.head<2>()).squared_m2);
  }
  const double part = std::ceil(inlier_ratio * static_cast<double>(squared_m2.size()) - 1e-9);
  const auto count = std::clamp<std::size_t>(static_cast<std::size_t>(part), 1, squared_m2.size());
  std::nth_element(squared_m2.begin(), squared_m2.begin() + static_cast<std::ptrdiff_t>(count) - 1,
                   squared_m2.end());
  double sum_m2 = 0.0;
  for (std::size_t k = 0; k < count; ++k) sum_m2 += squared_m2[k];
  return std::sqrt(sum_m2 / static_cast<double>(count));
}

}  // namespace honka
