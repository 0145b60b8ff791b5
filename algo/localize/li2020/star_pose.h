#pragma once

#include "algo/localize/li2020/star_dimensions.h"

namespace honka {

/// The rigid transform of one match. Metres, radians.
struct StarPose {
  double theta_rad = 0.0;
  Eigen::Vector2d printed_translation_m = Eigen::Vector2d::Zero();  ///< p_t = V̄' − V̄
  Eigen::Vector2d translation_m = Eigen::Vector2d::Zero();          ///< t = V̄' − R(theta) V̄
  double cost_m = 0.0;  ///< sum of |R (V − V̄) − (V' − V̄')|
};

/// Li2020 Eq. (3): of the six angles between centred paired vertices, the one that fits best.
///
/// local, map: six paired vertices; a vertex that two neighbours share is there twice. The vectors
/// are centred (V − V̄), as the text says: uncentred ones are wrong by tens of degrees. p_t as
/// printed does not belong to "rotate, then translate"; t does.
[[nodiscard]] StarPose star_pose(const StarVertices<2>& local_m, const StarVertices<2>& map_m);

/// The rigid transform of one match in space. Metres.
struct SpaceStarPose {
  Pose3 T_map_local = Pose3::Identity();
  Eigen::Vector3d printed_translation_m = Eigen::Vector3d::Zero();  ///< p_t = V̄' − V̄
  double cost_m = 0.0;  ///< sum of |R (V − V̄) − (V' − V̄')|
};

/// The same in space: the proper rotation of least squares over the six pairs (Arun et al. 1987),
/// as the angle between two vectors of one pair leaves the turn about them open.
[[nodiscard]] SpaceStarPose star_pose(const StarVertices<3>& local_m, const StarVertices<3>& map_m);

}  // namespace honka
