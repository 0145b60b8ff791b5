#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/registration/stem_grid.h"

namespace honka {

/// A motion in the plane: x' = R(yaw) x + shift.
struct PlanarMotion {
  double yaw_rad = 0.0;
  Eigen::Vector2d shift_m = Eigen::Vector2d::Zero();
};

/// All motions within half widths of a middle one. The half widths need not be equal.
struct MotionBox {
  PlanarMotion middle;
  double half_yaw_rad = 0.0;
  Eigen::Vector2d half_shift_m = Eigen::Vector2d::Zero();
};

/// The trimmed RMSE of source points moved onto target points: over the `inliers` smallest planar
/// nearest-neighbour distances. Bounded over boxes of motions by branch and bound. Metres.
class TrimmedObjective {
 public:
  /// Rotations are about the source's origin, so the source is best centred. `inliers` from 1 to
  /// the number of source points.
  TrimmedObjective(std::span<const Eigen::Vector2d> target_m,
                   std::span<const Eigen::Vector2d> source_m, std::size_t inliers, double margin_m);

  /// The objective at one motion.
  [[nodiscard]] double rmse(const PlanarMotion& motion);

  /// What a box holds.
  struct Bound {
    double lower_m = 0.0;   ///< no motion of the box is better than this
    double middle_m = 0.0;  ///< the objective in the middle, or infinite: above `interesting_m`
  };
  /// Nevalainen2021 Eq. (22), trimmed. Middles above `interesting_m` are not worked out; a lower
  /// bound at or above `enough_m` need not be the tightest.
  [[nodiscard]] Bound bound(const MotionBox& box, double interesting_m, double enough_m);

  /// A local minimum reached from `motion` by trimmed point-to-point ICP; never worse than it.
  [[nodiscard]] PlanarMotion polish(PlanarMotion motion);

  /// Root mean square distance of the source points from their origin: what a turn moves them by.
  [[nodiscard]] double lever_m() const { return lever_m_; }
  /// Steps of ICP so far.
  [[nodiscard]] int icp_steps() const { return icp_steps_; }

 private:
  void move_points(const PlanarMotion& motion);
  /// The motion of least squares for the inliers and their nearest target points, as moved last.
  [[nodiscard]] PlanarMotion fit_to_nearest();
  [[nodiscard]] double trimmed_rms(std::vector<double>& squared_m2) const;

  StemGrid target_;
  std::vector<double> x_, y_, radius_;  ///< of the source
  std::size_t inliers_;
  double lever_m_ = 0.0;
  std::vector<double> moved_x_, moved_y_, squared_, scratch_;
  std::vector<std::size_t> order_;
  int icp_steps_ = 0;
};

}  // namespace honka
