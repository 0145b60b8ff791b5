#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algo/slam/registration/nearest_stems.h"
#include "algo/slam/registration/registration.h"
#include "algo/slam/view_cone.h"

namespace honka {

/// Whether two clouds can be laid onto each other in the plane: as `registrable`, but of their
/// planar parts; kNotFinite also where coordinates are too large to be squared.
[[nodiscard]] RegistrationStatus registrable_in_plane(std::span<const Eigen::Vector3d> target_m,
                                                      std::span<const Eigen::Vector3d> source_m);

/// Where the target could have seen a stem: its cone about the origin, or, without one, the convex
/// hull of its points. In the plane, in the target's frame.
class CommonView {
 public:
  CommonView(std::span<const Eigen::Vector3d> target_m, const std::optional<ViewCone>& cone,
             double margin_m);
  [[nodiscard]] bool holds(const Eigen::Vector2d& place_in_target_m) const;
  /// λ of a pose; 1 without a cone.
  [[nodiscard]] double overlap(const Pose3& T_target_source) const;
  /// Chance that a place in the target's hull has a target point within `distance_m`.
  [[nodiscard]] double chance(double distance_m) const;

 private:
  std::optional<ViewCone> cone_;
  std::vector<Eigen::Vector2d> hull_;  ///< counter-clockwise
  double margin_m_;                    ///< by which the hull is widened
  double per_m2_ = 0.0;                ///< target points, over the hull
};

/// What the share test counts: source points with a target point within `distance_m` in the plane.
struct ShareCount {
  int in_view = 0;           ///< source points in the common view
  int partners_in_view = 0;  ///< those of them with a partner
  int partners = 0;          ///< of all source points
  [[nodiscard]] double share() const {
    return in_view > 0 ? static_cast<double>(partners_in_view) / in_view : 0.0;
  }
};
[[nodiscard]] ShareCount count_share(const NearestStems& target,
                                     std::span<const Eigen::Vector3d> source_m,
                                     const Pose3& T_target_source, const CommonView& view,
                                     double distance_m);

/// What a pose must pass to count.
struct ShareTest {
  double distance_m = 0.35;    ///< a neighbour nearer than this is a partner
  double min_share = 0.25;     ///< of the source points in the common view
  double min_evidence = 20.0;  ///< nats, see share_evidence
};

/// How much more than chance gives the partners are: n KL(k/n ‖ p), nats, for k partners of n
/// points, each of which has one by chance p. e to the minus this bounds the probability of as many
/// by chance (Chernoff), at one pose; a search that may look at a million poses needs 14 more than
/// one that looks at one. 0 where there are fewer than chance gives.
[[nodiscard]] double share_evidence(int partners, int points, double chance);

/// Writes overlap, inliers and share of the pose into `result`, and whether the pose passes:
/// kRegistered or kUnverified.
void judge_share(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                 const CommonView& view, const ShareTest& test, Registration& result);

/// Source and target points that are partners within `distance_m` in the plane, by index (source,
/// target), in order of the source.
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> partners_of(
    const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
    const Pose3& T_target_source, double distance_m);

/// RMSE of the nearest ⌈share · n⌉ source points' planar distances; at least one. Source not empty.
[[nodiscard]] double trimmed_planar_rmse(const NearestStems& target,
                                         std::span<const Eigen::Vector3d> source_m,
                                         const Pose3& T_target_source, double inlier_share);

/// How many points an inlier share means: ⌈share · n⌉, from 1 to n.
[[nodiscard]] std::size_t inlier_count(double inlier_share, std::size_t points);

/// Roll, pitch and z corrected so that partners (within `distance_m` in the plane) have the same
/// heights; the planar part stays but for what a tilt moves it. Fewer than six partners, or ones
/// nearly on a line, correct z alone; a tilt above 20° is not believed.
[[nodiscard]] Pose3 with_tilt(std::span<const Eigen::Vector3d> target_m, const NearestStems& target,
                              std::span<const Eigen::Vector3d> source_m,
                              const Pose3& T_target_source, double distance_m);

}  // namespace honka
