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
  std::int64_t neighbours = 5;     ///< nearest stems that form triangles with each stem
  double side_tolerance_m = 0.25;  ///< by which the sides of two triangles may differ
  std::int64_t candidates = 12;    ///< places with the most votes that are verified
  double inlier_share = 0.4;       ///< of the source points, for the reported RMSE
  double share_distance_m = 0.35;  ///< a neighbour nearer than this counts for the share
  double min_share = 0.25;         ///< of the source points in the common view, or refused
  double min_evidence = 20.0;      ///< nats by which partners must be more than chance gives
};
void describe(SettingsVisitor& v, LandmarkVotingSettings& s);

/// T_target_source over all yaws and translations: triangles of neighbouring stems that are alike
/// in both clouds vote for the pose that lays one on the other; the places with the most votes are
/// refined on their partners, until one gives partners to a third of the source; the one with the
/// most partners is the answer, if it passes the share test. Roll, pitch and z follow from the
/// partners' heights; both clouds must stand upright within some 10°. Where no place passes,
/// kUnverified, with the best of them, or the identity.
[[nodiscard]] Registration register_by_landmarks(
    std::span<const Eigen::Vector3d> target_m, std::span<const Eigen::Vector3d> source_m,
    const LandmarkVotingSettings& settings, const std::optional<ViewCone>& cone = std::nullopt);

}  // namespace honka
