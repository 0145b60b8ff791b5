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

 private:
  std::optional<ViewCone> cone_;
  std::vector<Eigen::Vector2d> hull_;  ///< counter-clockwise
  double margin_m_;                    ///< by which the hull is widened
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

/// Writes overlap, inliers and share of the pose into `result`, and whether the pose passes:
/// kRegistered or kUnverified. At least three partners in view and `min_share` of the points there.
void judge_share(const NearestStems& target, std::span<const Eigen::Vector3d> source_m,
                 const CommonView& view, double distance_m, double min_share, Registration& result);

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
