#pragma once

#include <cstdint>
#include <span>

#include "algo/slam/registration/nearest_stems.h"
#include "algo/slam/registration/registration.h"
#include "algo/types/settings.h"

namespace honka {

/// Trimmed point-to-point ICP as Matlab's pcregistericp does it, with tolerances tight enough to
/// end at the fixed point; Matlab's own are 0.01 m and 0.5 degrees.
struct TrimmedIcpSettings {
  double inlier_ratio = 0.4;  ///< nearest part of the source points that each step is fitted to
  std::int64_t max_iterations = 30;
  double tolerance_m = 0.002;      ///< mean movement of the last three steps that ends it …
  double tolerance_deg = 0.01;     ///< … together with their mean turn
  double share_distance_m = 0.35;  ///< a partner nearer than this counts for `inliers`
};
void describe(SettingsVisitor& v, TrimmedIcpSettings& s);

/// Lays `source_m` (points in the source frame) onto `target_m` from the guess.
///
/// Each step keeps the ⌈inlier_ratio · N⌉ source points (at least three) nearest to their partners
/// in space. The answer's `rmse_m` is over those at the final pose; `inliers` and `share` count,
/// among all source points, those with a partner under the share distance; `overlap` stays 1. Fewer
/// than three distinct points or points all on one line, in either cloud, give kTooFewPoints; a
/// coordinate that is not finite kNotFinite; the pose is then the guess. Otherwise kRegistered,
/// whether or not it converged to the truth: the caller verifies. Source: Nevalainen2021 §2.2,
/// Chetverikov2002.
[[nodiscard]] Registration trimmed_icp(std::span<const Eigen::Vector3d> target_m,
                                       std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source_guess,
                                       const TrimmedIcpSettings& settings);

/// The same with the target's neighbour search made before, for many sources or guesses. `target_m`
/// are the points that `target` was made of; `registrable` has passed them.
[[nodiscard]] Registration trimmed_icp(const NearestStems& target,
                                       std::span<const Eigen::Vector3d> target_m,
                                       std::span<const Eigen::Vector3d> source_m,
                                       const Pose3& T_target_source_guess,
                                       const TrimmedIcpSettings& settings);

/// Whether a cloud can be registered: kRegistered, kTooFewPoints (fewer than three distinct points
/// or all within 1 mm of a line) or kNotFinite.
[[nodiscard]] RegistrationStatus registrable(std::span<const Eigen::Vector3d> points_m);

}  // namespace honka
