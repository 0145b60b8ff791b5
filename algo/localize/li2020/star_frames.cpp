#include "algo/localize/li2020/star_frames.h"

namespace honka {

void set_pose(const StarPose& pose, PoseCandidate& candidate, StarMatch& match) {
  match.theta_rad = pose.theta_rad;
  match.printed_translation_m = pose.printed_translation_m;
  match.translation_m = pose.translation_m;
  match.cost_m = pose.cost_m;
  candidate.T_map_local = {pose.translation_m, pose.theta_rad};
}

void set_pose(const SpaceStarPose& pose, PoseCandidateIn<3>& candidate, StarMatch& match) {
  match.theta_rad = yaw_of(pose.T_map_local);
  match.printed_translation_m = pose.printed_translation_m.head<2>();
  match.translation_m = pose.T_map_local.translation().head<2>();
  match.cost_m = pose.cost_m;
  candidate.T_map_local = pose.T_map_local;
}

void restore_frames(StarMatch& match, const Pose2& T_centred, const Eigen::Vector2d& local_centre_m,
                    const Eigen::Vector2d& map_centre_m) {
  match.printed_translation_m += map_centre_m - local_centre_m;
  match.translation_m += map_centre_m - Eigen::Rotation2Dd(T_centred.yaw_rad) * local_centre_m;
}

void restore_frames(StarMatch& match, const Pose3& T_centred, const Eigen::Vector3d& local_centre_m,
                    const Eigen::Vector3d& map_centre_m) {
  match.printed_translation_m += (map_centre_m - local_centre_m).head<2>();
  match.translation_m += (map_centre_m - T_centred.linear() * local_centre_m).head<2>();
}

void set_answer(LocateResult& result, const Pose2& T_centred, const Eigen::Vector2d& local_centre_m,
                const Eigen::Vector2d& map_centre_m) {
  const double yaw = T_centred.yaw_rad;
  result.T_map_local = {
      T_centred.translation_m + map_centre_m - Eigen::Rotation2Dd(yaw) * local_centre_m,
      wrap_to_pi(yaw)};
}

void set_answer(LocateResult& result, const Pose3& T_centred, const Eigen::Vector3d& local_centre_m,
                const Eigen::Vector3d& map_centre_m) {
  Pose3 T_map_local = T_centred;
  T_map_local.translation() += map_centre_m - T_centred.linear() * local_centre_m;
  result.T_map_local_3d = T_map_local;
  result.T_map_local = planar(T_map_local);
}

}  // namespace honka
