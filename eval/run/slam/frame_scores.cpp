#include "eval/run/slam/frame_scores.h"

#include "eval/metrics/stem_scores.h"

namespace honka::eval {
namespace {

/// True stems about a key frame, in its lidar's frame.
struct StemsAround {
  std::vector<Eigen::Vector3d> points_m;
  std::vector<bool> in_view;
};

StemsAround stems_around(const SlamDrive& drive, std::size_t frame, const ViewCone& cone,
                         double gate_m) {
  const Pose3 T_lidar_first = drive.true_T_first_frame[frame].inverse();
  StemsAround around;
  for (const Eigen::Vector3d& stem_in_first : drive.true_stems_in_first_m) {
    const Eigen::Vector3d stem_in_lidar = T_lidar_first * stem_in_first;
    const Eigen::Vector2d plane = stem_in_lidar.head<2>();
    if (plane.norm() > cone.range_m + gate_m) continue;
    around.points_m.push_back(stem_in_lidar);
    around.in_view.push_back(cone.holds(plane));
  }
  return around;
}

std::vector<Eigen::Vector2d> planes_of(const std::vector<Eigen::Vector3d>& points_m) {
  std::vector<Eigen::Vector2d> planes;
  for (const Eigen::Vector3d& point : points_m) planes.emplace_back(point.head<2>());
  return planes;
}

FrameScores score_frame(const SlamDrive& drive, std::size_t frame, const ViewCone& cone,
                        double gate_m) {
  const StemsAround around = stems_around(drive, frame, cone, gate_m);
  const auto& found = drive.frames[frame].points_m;
  FrameScores scores;
  scores.frames = 1;
  scores.found = static_cast<std::int64_t>(found.size());
  for (const bool in_view : around.in_view) scores.truth += in_view ? 1 : 0;
  for (const StemPair& pair : match_stems(planes_of(found), planes_of(around.points_m), gate_m)) {
    const Eigen::Vector3d truth = around.points_m[pair.truth];
    const Eigen::Vector3d error = found[pair.found] - truth;
    ++scores.found_matched;
    scores.truth_matched += around.in_view[pair.truth] ? 1 : 0;
    scores.planar_m2 += error.head<2>().squaredNorm();
    scores.height_m2 += error.z() * error.z();
    scores.radial_m += error.head<2>().dot(truth.head<2>().stableNormalized());
  }
  return scores;
}

}  // namespace

void FrameScores::add(const FrameScores& other) {
  frames += other.frames;
  found += other.found;
  found_matched += other.found_matched;
  truth += other.truth;
  truth_matched += other.truth_matched;
  planar_m2 += other.planar_m2;
  height_m2 += other.height_m2;
  radial_m += other.radial_m;
}

FrameScores score_frames(const SlamDrive& drive, const ViewCone& cone, double gate_m) {
  FrameScores scores;
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    scores.add(score_frame(drive, i, cone, gate_m));
  }
  return scores;
}

}  // namespace honka::eval
