#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

namespace honka {

/// A point of a cluster in the plane and the unit direction from its sensor towards it.
struct SeenPoint {
  Eigen::Vector2d position_m;
  Eigen::Vector2d ray;
};

/// A stem's cross-section.
struct Circle {
  Eigen::Vector2d centre_m;
  double radius_m = 0.0;
};

/// Depth of the mean of the near side of a circle, in radii: ∫√(1 − u²) du / 2 over [−1, 1] = π/4,
/// the beams of a sweep being spread evenly across the stem.
inline constexpr double kMeanDepth = 0.785398163397448;

/// The mean of the points: Li2020's landmark. It lies kMeanDepth · r towards the sensor.
[[nodiscard]] Eigen::Vector2d mean_of(std::span<const SeenPoint> points);

/// Shifts the mean by kMeanDepth · r along the mean ray; r from the apparent width.
///
/// Beams spread evenly across a stem have offsets u from its axis that are uniform in [−r, r], so
/// r is twice the median of |u|, which a few branches change less than they change the width. A
/// fifth of the points in a branch on one side still widens r by 40 %. r is held in 0.02–0.4 m.
[[nodiscard]] Circle bias_corrected(std::span<const SeenPoint> points);

/// Least-squares circle where the arc allows: algebraic start (Taubin 1991, by Chernov's Newton
/// iteration), then Gauss–Newton on the distances with Tukey weights. Nothing when it has fewer
/// than 8 points, an arc below 90°, a radius outside 0.03–0.4 m, a residual above 3 cm or a quarter
/// of the radius, or a centre that is not behind the points as the sensor sees them.
[[nodiscard]] std::optional<Circle> circle_fit(std::span<const SeenPoint> points);

}  // namespace honka
