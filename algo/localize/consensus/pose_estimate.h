#pragma once

#include <Eigen/Core>
#include <optional>

#include "algo/localize/consensus/fit.h"
#include "algo/localize/consensus/judge.h"

namespace honka {

/// The pose of an answer and what is known of its error.
struct PoseEstimate {
  Placement T_map_sensor;      ///< in the index's coordinates; yaw is that of the sensor's x axis
  double sigma_m = 0.0;        ///< of seen against mapped stems on each axis
  double false_share = 0.0;    ///< of the local stems
  double radial_bias_m = 0.0;  ///< local stems lie so much too near to the sensor; 0: none certain
  /// (xx, yy, xy) along the sensor's axes that the list needs to lie on the map; 0: none certain.
  Eigen::Vector3d strain = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the sensor's x, y, yaw in the map
};

/// The maximum-likelihood pose around a settled fit: every local stem is any of the map stems
/// around it, or false, no map stem is two; noise and the share of false stems are estimated with
/// it, and a radial bias once it exceeds `radial_bias_sds` of its own standard deviations, and a
/// strain (of a list that was not levelled on a slope) once it is certain. The
/// covariance is the inverse of the information that unknown partners leave (Louis: Finding the
/// observed information matrix when using the EM algorithm, J. R. Stat. Soc. B 44(2), 1982).
/// Nothing where this leads away from the fit's place.
[[nodiscard]] std::optional<PoseEstimate> estimate_pose(const Judge& judge,
                                                        const Eigen::Vector2d& sensor_in_frame_m,
                                                        const Fit& start);

}  // namespace honka
