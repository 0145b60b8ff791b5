#pragma once

#include <Eigen/Core>
#include <cmath>

#include "algo/types/pose.h"

namespace honka {

/// Turn and shift of the frame into the map, without angles: cheap to apply a
/// million times.
struct Placement {
  double cosine = 1.0, sine = 0.0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d turned(const Eigen::Vector2d& q) const {
    return {cosine * q.x() - sine * q.y(), sine * q.x() + cosine * q.y()};
  }
  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& q) const {
    return turned(q) + shift_m;
  }
  [[nodiscard]] double yaw_rad() const { return std::atan2(sine, cosine); }
};

/// Weighted least squares of pairs (q in the frame, m in the map), summed up
/// one by one.
struct PairSums {
  double weight = 0.0;
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  double from_squared = 0.0, to_squared = 0.0, dot = 0.0, cross = 0.0;

  void add(const Eigen::Vector2d& q, const Eigen::Vector2d& m, double w) {
    weight += w;
    from += w * q;
    to += w * m;
    from_squared += w * q.squaredNorm();
    to_squared += w * m.squaredNorm();
    dot += w * q.dot(m);
    cross += w * (q.x() * m.y() - q.y() * m.x());
  }
};

/// A placement with what is known of its error: about the weighted middle of
/// the pairs, turn and shift are independent.
struct Fit {
  Placement placement;
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();  ///< of the paired stems, in the frame
  double weight = 0.0;                                 ///< number of pairs
  double spread_m2 = 0.0;                              ///< Σ w |q − middle|²
  double squares_m2 = 0.0;                             ///< Σ w |residual|²
  double sigma_m = 0.0;                                ///< residuals on each axis
  double evidence_nats = 0.0;  ///< ln odds of this place over "nothing of the map is here"
  int inliers = 0;

  /// Variance of a residual at q, on each axis: noise, and the error of shift
  /// and turn there.
  [[nodiscard]] double variance_at(const Eigen::Vector2d& q) const {
    return sigma_m * sigma_m * (1.0 + 1.0 / weight + (q - middle_m).squaredNorm() / spread_m2);
  }
};

/// The least-squares fit; sigma_m is left at 0. `origin_m`: near the map stems,
/// for the digits; the sums hold m − origin_m.
[[nodiscard]] inline Fit solve(const PairSums& s, const Eigen::Vector2d& origin_m) {
  Fit fit;
  fit.weight = s.weight;
  const Eigen::Vector2d from = s.from / s.weight;
  const Eigen::Vector2d to = s.to / s.weight;
  const double dot = s.dot - s.from.dot(to);
  const double cross = s.cross - (s.from.x() * to.y() - s.from.y() * to.x());
  const double length = std::sqrt(dot * dot + cross * cross);
  if (length > 0.0) {
    fit.placement.cosine = dot / length;
    fit.placement.sine = cross / length;
  }
  fit.placement.shift_m = to - fit.placement.turned(from) + origin_m;
  fit.middle_m = from;
  fit.spread_m2 = std::max(s.from_squared - s.from.dot(from), 1e-9);
  const double to_spread = s.to_squared - s.to.dot(to);
  fit.squares_m2 = std::max(fit.spread_m2 + to_spread - 2.0 * length, 0.0);
  return fit;
}

}  // namespace honka
