#pragma once

#include "algo/localize/li2020/selection.h"
#include "algo/localize/li2020/star_pose.h"
#include "algo/localize/matcher.h"

namespace honka {

// Poses between the centred coordinates that are matched in and those of the lists that were given,
// in the plane and in space. Of a pose in space a match is told the plan.

/// The pose of one match in centred coordinates.
void set_pose(const StarPose& pose, PoseCandidate& candidate, StarMatch& match);
void set_pose(const SpaceStarPose& pose, PoseCandidateIn<3>& candidate, StarMatch& match);

/// Adds to the translations of a match what centring took.
void restore_frames(StarMatch& match, const Pose2& T_centred, const Eigen::Vector2d& local_centre_m,
                    const Eigen::Vector2d& map_centre_m);
void restore_frames(StarMatch& match, const Pose3& T_centred, const Eigen::Vector3d& local_centre_m,
                    const Eigen::Vector3d& map_centre_m);

/// The chosen pose as the answer.
void set_answer(LocateResult& result, const Pose2& T_centred, const Eigen::Vector2d& local_centre_m,
                const Eigen::Vector2d& map_centre_m);
void set_answer(LocateResult& result, const Pose3& T_centred, const Eigen::Vector3d& local_centre_m,
                const Eigen::Vector3d& map_centre_m);

}  // namespace honka
