#pragma once

#include <Eigen/Core>
#include <vector>

#include "algo/localize/li2020/selection.h"

namespace honka {

/// Covariance of the pose that Eq. (4) chooses: that of least squares over the six pairs of the
/// chosen match alone, since the pose is this match's, with the noise of a pair from the residuals
/// of all matches that agree. The paper states none.
///
/// agreeing: at least one; chosen: the match of the pose; sensor_m: in the frame of the local
/// vertices → of the sensor's (x, y, yaw) in the map's axes; m², rad². Nothing where all pairs fit
/// exactly or the chosen vertices are one point.
[[nodiscard]] std::optional<Eigen::Matrix3d> pose_covariance(
    const std::vector<PoseCandidate>& agreeing, const PoseCandidate& chosen,
    const Pose2& T_map_local, const Eigen::Vector2d& sensor_m);

}  // namespace honka
