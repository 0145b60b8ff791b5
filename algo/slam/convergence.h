#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "algo/types/pose.h"

namespace honka {

/// Whether the rim of a cloud counts for L0: the points of the convex hull and their natural
/// neighbours, whose edges are long because nothing is seen beyond.
enum class Periphery { kLeftOut, kCounted };

/// L0: the mean over the points of their mean distance to their natural neighbours, those that an
/// edge of the planar Delaunay triangulation joins them to. Where the whole cloud is rim, all of it
/// counts; 0 where there is no triangle. Points that are not finite are left out.
/// Source: Nevalainen2021 Eq. (23).
[[nodiscard]] double mean_neighbour_distance_m(std::span<const Eigen::Vector3d> points_m,
                                               Periphery periphery = Periphery::kLeftOut);

/// What each point of a cloud has around it in the plane.
struct NaturalNeighbours {
  std::vector<double> distance_m;  ///< mean to the natural neighbours; 0 for a point without any
  std::vector<bool> on_rim;        ///< the point or a natural neighbour of it is on the hull
};

/// The summands of Eq. 23, point by point; points that are not finite have no neighbours.
[[nodiscard]] NaturalNeighbours natural_neighbours(std::span<const Eigen::Vector3d> points_m);

/// How far a guess may be off for a simple ICP to find the match: half axes of an ellipsoid.
struct ConvergenceLimits {
  double translation_m = 0.0;  ///< δ0
  double rotation_rad = 0.0;   ///< θ0, about the vertical
  double tilt_rad = 0.0;       ///< φ0, of the vertical
};

/// The paper's tilt limit, found by it in a numerical test (§2.3).
inline constexpr double kPaperTiltLimitDeg = 8.2;

/// δ0 = L0/2 and θ0 = δ0 / (√(1−γ) R). With the paper's L0 = 3.5 m, γ = 0.6 and R = 35 m that is
/// 1.75 m and 4.53°; the paper prints 3.7°, which is √γ in place of √(1−γ).
/// Source: Nevalainen2021 Eq. (24), Nevalainen2021 Eq. (25).
[[nodiscard]] ConvergenceLimits convergence_limits(double mean_neighbour_distance_m,
                                                   double outlier_ratio, double range_m,
                                                   double tilt_deg = kPaperTiltLimitDeg);

/// (δ/δ0)² + (θ/θ0)² + (φ/φ0)²: at most 1 where ICP is expected to succeed.
/// Source: Nevalainen2021 Eq. (26) with the tilt term of §2.3.
[[nodiscard]] double convergence_measure(const Pose3& mismatch, const ConvergenceLimits& limits);

/// Yaw about the vertical (θ) and the angle between the verticals (φ) of a rotation. Radians, ≥ 0.
[[nodiscard]] Eigen::Vector2d turn_and_tilt(const Eigen::Matrix3d& rotation);

}  // namespace honka
