#pragma once

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

/// λ: the part of the source's cone that lies in the target's cone too, in [0, 1], from a fixed
/// sunflower of `samples` points of equal area (Nevalainen2021, Fig. 8). Planar: roll, pitch and z
/// are left out.
[[nodiscard]] double view_overlap(const Pose2& T_target_source, const ViewCone& cone,
                                  int samples = 256);

}  // namespace honka
