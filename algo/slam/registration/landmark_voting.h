#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "algo/slam/registration/registration.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// Registration of sparse clouds without any initial guess.
struct LandmarkVotingSettings {
  double longest_side_m = 14.0;    ///< of the point pairs that vote
  double side_tolerance_m = 0.20;  ///< by which the sides of two pairs may differ
  std::int64_t candidates = 24;    ///< places with the most votes that are verified
  double inlier_share = 0.4;       ///< of the source points, for the reported RMSE
  double share_distance_m = 0.35;  ///< a neighbour nearer than this counts for the share
  double min_share = 0.25;         ///< of the overlap's source points, or the pose is refused
};
void describe(SettingsVisitor& v, LandmarkVotingSettings& s);

/// T_target_source over all yaws and translations: pairs of stems equally far apart in both clouds
/// vote for the pose that lays one on the other; the places with the most votes are verified by the
/// share test and refined on their partners. Roll, pitch and z follow from the partners; both
/// clouds must stand upright within some 10°. The overlap is counted in the target's cone, or,
/// without one, in the target's convex hull. kUnverified where no place passes.
[[nodiscard]] Registration register_by_landmarks(
    std::span<const Eigen::Vector3d> target_m, std::span<const Eigen::Vector3d> source_m,
    const LandmarkVotingSettings& settings, const std::optional<ViewCone>& cone = std::nullopt);

}  // namespace honka
