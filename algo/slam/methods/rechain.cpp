#include "algo/slam/methods/rechain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/slam/chain.h"
#include "algo/slam/methods/checked_match.h"
#include "algo/types/angles.h"
#include "algo/types/check.h"

namespace honka {
namespace {

using Points = std::span<const Eigen::Vector3d>;

/// Starts of the search that ICP goes on from: the best of the lattice.
constexpr std::size_t kSearchStarts = 5;

/// A pose of the lattice about the prediction, and how well it fits.
struct LatticePose {
  Pose3 T_target_source;
  double error_m = 0.0;
};

/// The poses of a lattice about the prediction whose trimmed error is least, the best in front.
std::vector<LatticePose> search_about(const MatchTarget& target, Points source_m,
                                      const Pose3& prediction, const RechainSettings& s) {
  const auto reach = static_cast<int>(std::floor(s.search_distance_m / s.search_step_m));
  const auto turns = static_cast<int>(std::floor(s.search_turn_deg / s.search_step_deg));
  std::vector<LatticePose> found;
  for (int turn = -turns; turn <= turns; ++turn) {
    const Eigen::AngleAxisd about_z(deg_to_rad(turn * s.search_step_deg), Eigen::Vector3d::UnitZ());
    Pose3 pose = prediction;
    pose.linear() = about_z * prediction.linear();
    for (int x = -reach; x <= reach; ++x) {
      for (int y = -reach; y <= reach; ++y) {
        pose.translation() = prediction.translation() +
                             Eigen::Vector3d(x * s.search_step_m, y * s.search_step_m, 0.0);
        found.push_back({pose, target.trimmed_error_m(source_m, pose, s.inlier_ratio)});
      }
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const LatticePose& a, const LatticePose& b) {
    return a.error_m < b.error_m;
  });
  if (found.size() > kSearchStarts) found.resize(kSearchStarts);
  return found;
}

/// A step of the chain and how it came about.
struct Step {
  Pose3 T_target_source;
  StepStatus status = StepStatus::kUnverified;
};

/// ICP from the chain's own step and from the prediction; where neither passes, from the search.
Step register_step(const MatchTarget& target, Points source_m, const Pose3& by_chain,
                   const Pose3& prediction, const MatchRules& rules, const RechainSettings& s) {
  if (!target.registrable() || registrable(source_m) != RegistrationStatus::kRegistered) {
    return {prediction, StepStatus::kTooFewPoints};
  }
  for (const Pose3& guess : {by_chain, prediction}) {
    const CheckedMatch match = target.match(source_m, guess, rules);
    if (match.passed) return {match.T_target_source, StepStatus::kRegistered};
  }
  CheckedMatch best;
  for (const LatticePose& start : search_about(target, source_m, prediction, s)) {
    const CheckedMatch match = target.match(source_m, start.T_target_source, rules);
    if (match.passed && match.quality.share > best.quality.share) best = match;
  }
  if (best.passed) return {best.T_target_source, StepStatus::kSearched};
  return {prediction, StepStatus::kUnverified};
}

}  // namespace

std::string_view step_status_name(StepStatus status) {
  constexpr std::array<std::string_view, 4> kNames = {"registered", "searched", "unverified",
                                                      "too_few_points"};
  return kNames.at(static_cast<std::size_t>(status));
}

std::size_t Rechain::bad_steps() const {
  return static_cast<std::size_t>(std::count_if(steps.begin(), steps.end(), [](StepStatus s) {
    return s == StepStatus::kUnverified || s == StepStatus::kTooFewPoints;
  }));
}

Rechain reregister_chain(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
                         const ViewCone& cone, const MatchQualitySettings& quality,
                         const RechainSettings& settings, const StageProgress& progress) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  const MatchRules rules{settings.inlier_ratio, settings.polish_distance_m, settings.min_share,
                         cone, quality};
  Rechain result;
  if (!frames.empty()) result.T_first_frame.push_back(Pose3::Identity());
  Pose3 prediction = Pose3::Identity();  // the last good step: constant velocity
  for (std::size_t l = 0; l + 1 < frames.size(); ++l) {
    const MatchTarget target(frames[l].points_m);
    const Pose3 by_chain = between(T_first_frame, l, l + 1);
    // Across missing numbers the last step says nothing of this one; the chain does.
    const bool follows = frames[l + 1].number == frames[l].number + 1;
    const Step step = register_step(target, frames[l + 1].points_m, by_chain,
                                    follows ? prediction : by_chain, rules, settings);
    const bool good =
        step.status == StepStatus::kRegistered || step.status == StepStatus::kSearched;
    if (good && follows) prediction = step.T_target_source;
    result.steps.push_back(step.status);
    Pose3 next = result.T_first_frame.back() * step.T_target_source;
    next.linear() = Eigen::Quaterniond(next.linear()).normalized().toRotationMatrix();
    result.T_first_frame.push_back(next);
    if (progress) progress(l + 2, frames.size());
  }
  return result;
}

}  // namespace honka
