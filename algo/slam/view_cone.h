#pragma once

#include <vector>

#include "algo/types/pose.h"
#include "algo/types/settings.h"

namespace honka {

/// What a frame can see in the plane: a sector about the lidar's x axis (Nevalainen2021, Fig. 8).
struct ViewCone {
  double range_m = 35.0;
  double angle_deg = 210.0;  ///< whole opening, centred on x ahead

  [[nodiscard]] bool holds(const Eigen::Vector2d& point_in_lidar_m) const;
};
void describe(SettingsVisitor& v, ViewCone& s);

/// Overlaps of one cone at many poses: the samples are laid out once.
///
/// λ is the part of the source's cone that lies in the target's cone too, in [0, 1], counted over a
/// sunflower of equal areas: sample k at the range R √((k + ½)/N) and at the share of the opening
/// that is the fractional part of (k + ½)(√5 − 1)/2. Planar: tilt and z are left out.
/// Source: Nevalainen2021 Fig. 8.
class ViewOverlap {
 public:
  explicit ViewOverlap(const ViewCone& cone, int samples = 256);

  [[nodiscard]] double operator()(const Pose2& T_target_source) const;
  /// Of the planar motion nearest to a motion in space (`nearest_planar`).
  [[nodiscard]] double operator()(const Pose3& T_target_source) const;

  /// The samples, in the lidar frame.
  [[nodiscard]] std::vector<Eigen::Vector2d> samples() const;

 private:
  double range_squared_m2_, cos_half_, sin_half_;
  bool all_round_;
  std::vector<double> x_, y_;
};

/// λ of a single pose, see ViewOverlap.
[[nodiscard]] double view_overlap(const Pose2& T_target_source, const ViewCone& cone,
                                  int samples = 256);
[[nodiscard]] double view_overlap(const Pose3& T_target_source, const ViewCone& cone,
                                  int samples = 256);

/// The planar motion nearest to one in space: x, y, and the yaw whose rotation about z is nearest
/// in the sense of least squares. Differs from `planar` in the second order of the tilt.
[[nodiscard]] Pose2 nearest_planar(const Pose3& T_a_b);

}  // namespace honka
