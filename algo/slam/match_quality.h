#pragma once

#include <cstdint>
#include <span>

#include "algo/slam/registration/nearest_stems.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// How a match of two frames is judged.
struct MatchQualitySettings {
  double inlier_ratio = 0.4;       ///< best part of the distances that e is taken over; 1 − γ
  double share_distance_m = 0.35;  ///< a neighbour nearer than this counts for the share
  std::int64_t min_points = 8;     ///< in the common view; fewer judge nothing
};
void describe(SettingsVisitor& v, MatchQualitySettings& s);

/// A match of two frames, judged in their common view.
struct MatchQuality {
  int points = 0;        ///< source points that the target's cone holds
  double error_m = 0.0;  ///< e: RMSE of the best part of nearest-neighbour distances
  double mean_m = 0.0;   ///< mean of all of them
  double share = 0.0;    ///< part of them under the share distance
};

/// Judges T_target_source over the source points that lie in the target's cone (seen from above);
/// distances to the nearest target points are in space. The best part is ⌈inlier_ratio · points⌉
/// distances. Where `points` is below `min_points`, or the target or the pose is of no use (no
/// points, or a point that is not finite is taken for absent), error and mean are infinite and the
/// share is 0; never NaN.
/// Source: Nevalainen2021 §2.3, §2.4 (e of a match, non-overlapping parts excluded).
[[nodiscard]] MatchQuality judge_match(std::span<const Eigen::Vector3d> target_m,
                                       std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source, const ViewCone& cone,
                                       const MatchQualitySettings& settings);

/// The same with the target's neighbour search made before, for many sources or poses.
[[nodiscard]] MatchQuality judge_match(const NearestStems& target,
                                       std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source, const ViewCone& cone,
                                       const MatchQualitySettings& settings);

}  // namespace honka
