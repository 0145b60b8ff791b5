#include "eval/run/localize/map_bend.h"

#include "algo/geometry/fit_pose.h"
#include "eval/metrics/stem_scores.h"

namespace honka::eval {
namespace {

constexpr double kBendReach_m = 50.0;  // a drift is correlated over some 100 m
constexpr std::size_t kFewestBendPairs = 10;

Eigen::Vector3d in_plane(const Eigen::Vector2d& place_m) { return {place_m.x(), place_m.y(), 0.0}; }

}  // namespace

std::optional<Pose2> map_bend(const TrunkMap& map, const StemMap& stems_in_world,
                              const Eigen::Vector2d& place_in_world_m, double gate_m) {
  std::vector<Eigen::Vector2d> mapped_m, trees_m;
  for (const ObservedStem& stem : map.stems) {
    if ((stem.position_m - place_in_world_m).norm() < kBendReach_m)
      mapped_m.push_back(stem.position_m);
  }
  for (const Stem& stem : stems_in_world) {
    if ((stem.position_m - place_in_world_m).norm() < kBendReach_m + gate_m)
      trees_m.push_back(stem.position_m);
  }
  std::vector<Eigen::Vector3d> target_m, source_m;
  for (const StemPair& pair : match_stems(mapped_m, trees_m, gate_m)) {
    target_m.push_back(in_plane(mapped_m[pair.found]));
    source_m.push_back(in_plane(trees_m[pair.truth]));
  }
  if (target_m.size() < kFewestBendPairs) return std::nullopt;
  return planar(fit_pose(target_m, source_m));
}

}  // namespace honka::eval
