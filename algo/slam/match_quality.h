#pragma once

#include <span>

#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// How a match of two frames is judged.
struct MatchQualitySettings {
  double inlier_ratio = 0.4;       ///< best part of the distances that e is taken over; 1 − γ
  double share_distance_m = 0.35;  ///< a neighbour nearer than this counts for the share
};
void describe(SettingsVisitor& v, MatchQualitySettings& s);

/// A match of two frames, judged in their common view.
struct MatchQuality {
  int points = 0;        ///< source points that the target's cone holds
  double error_m = 0.0;  ///< e: RMSE of the best part of nearest-neighbour distances
  double mean_m = 0.0;   ///< mean of all of them
  double share = 0.0;    ///< part of them under the share distance
};

/// Judges T_target_source over the source points that lie in the target's cone; distances are
/// planar. `points` = 0 leaves error and mean infinite and the share 0; never NaN.
[[nodiscard]] MatchQuality judge_match(std::span<const Eigen::Vector3d> target_m,
                                       std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source, const ViewCone& cone,
                                       const MatchQualitySettings& settings);

}  // namespace honka
