#include "eval/run/stem_judgement.h"

#include <cmath>

#include "algo/geometry/kdtree.h"

namespace honka::eval {
namespace {

StemSet stem_set(const std::vector<ObservedStem>& stems, const Pose2& T_world_stems) {
  StemSet set;
  for (const ObservedStem& stem : stems) {
    set.positions_m.push_back(T_world_stems * stem.position_m);
    set.dbh_m.push_back(stem.dbh_m);
  }
  return set;
}

template <class Keep>
StemSet truth_where(const StemMap& stems, const Keep& keep) {
  StemSet set;
  for (const Stem& stem : stems) {
    if (!keep(stem.position_m)) continue;
    set.positions_m.push_back(stem.position_m);
    set.dbh_m.push_back(stem.dbh_m);
  }
  return set;
}

}  // namespace

StemScores score_window(const std::vector<ObservedStem>& stems_in_local,
                        const StemMap& stems_in_world, const Pose2& T_world_local,
                        double field_of_view_rad, double gate_m) {
  const Pose2 T_local_world = T_world_local.inverse();
  const StemSet truth = truth_where(stems_in_world, [&](const Eigen::Vector2d& stem_in_world) {
    const Eigen::Vector2d stem_in_local = T_local_world * stem_in_world;
    return stem_in_local.norm() < kStemRanges_m.back() &&
           std::abs(std::atan2(stem_in_local.y(), stem_in_local.x())) <= field_of_view_rad / 2;
  });
  return score_stems(stem_set(stems_in_local, T_world_local), truth, T_world_local.translation_m,
                     gate_m, {kStemRanges_m.begin(), kStemRanges_m.end()});
}

StemScores score_map(const TrunkMap& map, const StemMap& stems_in_world, const Drive& run,
                     double reach_m, double gate_m) {
  std::vector<Eigen::Vector2d> track;
  for (const KeyFrame& key_frame : run.key_frames) {
    track.push_back(key_frame.T_world_lidar.translation().head<2>());
  }
  const KdTree2 near(track);
  const StemSet truth = truth_where(
      stems_in_world, [&](const Eigen::Vector2d& stem) { return near.any_within(stem, reach_m); });
  return score_stems(stem_set(map.stems, Pose2{}), truth, Eigen::Vector2d::Zero(), gate_m);
}

}  // namespace honka::eval
