#include "eval/run/localize/map_update_quality.h"

#include <cmath>

#include "algo/types/angles.h"
#include "eval/metrics/stem_scores.h"

namespace honka::eval {
namespace {

using Stems2d = std::vector<Eigen::Vector2d>;

/// The area that was seen: within range and view of any of the first lists.
class SeenArea {
 public:
  SeenArea(const MapUpdateWorld& world, std::size_t lists, const MapUpdateSettings& updater)
      : range_m_(updater.range_m), half_view_rad_(0.5 * deg_to_rad(updater.field_of_view_deg)) {
    const std::size_t count = lists == 0 ? world.T_world_sensor.size() : lists;
    for (std::size_t k = 0; k < count; ++k) {
      T_sensor_world_.push_back(world.T_world_sensor[k].inverse());
    }
  }

  [[nodiscard]] bool holds(const Eigen::Vector2d& place_m) const {
    for (const Pose2& T_sensor_world : T_sensor_world_) {
      const Eigen::Vector2d local_m = T_sensor_world * place_m;
      if (local_m.norm() >= range_m_) continue;
      if (std::abs(std::atan2(local_m.y(), local_m.x())) <= half_view_rad_) return true;
    }
    return false;
  }

 private:
  double range_m_, half_view_rad_;
  std::vector<Pose2> T_sensor_world_;
};

/// The tree of each stem, −1 for none.
std::vector<std::int64_t> trees_of(const Stems2d& stems_m, const Stems2d& trees_m, double gate_m) {
  std::vector<std::int64_t> trees(stems_m.size(), -1);
  for (const StemPair& pair : match_stems(stems_m, trees_m, gate_m)) {
    trees[pair.found] = static_cast<std::int64_t>(pair.truth);
  }
  return trees;
}

struct StandingTrees {
  explicit StandingTrees(const sim::MappedForest& forest) {
    for (std::size_t i = 0; i < forest.trees_m.size(); ++i) {
      if (forest.standing[i] == 0) continue;
      places_m.push_back(forest.trees_m[i]);
      tree.push_back(i);
    }
  }
  Stems2d places_m;
  std::vector<std::size_t> tree;  ///< index among all trees of the forest
};

/// Judges the stems of the old map: kept or retired, rightly or not.
void judge_old_stems(const MapUpdateWorld& world, const MapSnapshot& snapshot,
                     const std::vector<std::int64_t>& trees, const SeenArea& area,
                     JudgedMap& judged) {
  MapQuality& q = judged.quality;
  std::vector<std::uint8_t> retired(world.old_map_m.size(), 0);
  for (const std::size_t i : snapshot.update.retired) retired[i] = 1;
  for (std::size_t i = 0; i < world.old_map_m.size(); ++i) {
    const bool stands =
        trees[i] >= 0 && world.forest.standing[static_cast<std::size_t>(trees[i])] != 0;
    const bool seen = area.holds(world.old_map_m[i]);
    const StemFate gone = stands ? StemFate::kWronglyRetired : StemFate::kRetired;
    const StemFate there = stands ? StemFate::kKept : StemFate::kStale;
    judged.stems.push_back({world.old_map_m[i], retired[i] != 0 ? gone : there, seen});
    if (!seen) continue;
    (stands ? q.standing : q.felled) += 1;
    (stands ? q.standing_retired : q.felled_retired) += retired[i];
  }
}

/// Judges the map as it is: precision and errors. Returns which standing trees it has.
std::vector<std::uint8_t> judge_present_map(const MapSnapshot& snapshot,
                                            const StandingTrees& standing, const SeenArea& area,
                                            double gate_m, JudgedMap& judged) {
  MapQuality& q = judged.quality;
  const Stems2d& map_m = snapshot.update.stems_in_map_m;
  const auto trees = trees_of(map_m, standing.places_m, gate_m);
  const std::size_t kept = map_m.size() - snapshot.update.added;
  std::vector<std::uint8_t> mapped(standing.places_m.size(), 0);
  for (std::size_t i = 0; i < map_m.size(); ++i) {
    const bool stands = trees[i] >= 0, joined = i >= kept, seen = area.holds(map_m[i]);
    if (stands) mapped[static_cast<std::size_t>(trees[i])] = 1;
    if (joined) {
      const StemFate fate = stands ? StemFate::kAdded : StemFate::kFalselyAdded;
      judged.stems.push_back({map_m[i], fate, seen});
    }
    if (!seen) continue;
    ++q.seen_stems;
    q.added += joined ? 1 : 0;
    q.falsely_added += joined && !stands ? 1 : 0;
    if (!stands) continue;
    ++q.seen_true;
    const Eigen::Vector2d& tree_m = standing.places_m[static_cast<std::size_t>(trees[i])];
    q.errors_m.push_back((map_m[i] - tree_m).norm());
    if (joined) q.added_errors_m.push_back(q.errors_m.back());
  }
  return mapped;
}

/// Counts the standing trees: mapped, and of those that the old map lacked, added.
void judge_trees(const StandingTrees& standing, const std::vector<std::uint8_t>& mapped,
                 const std::vector<std::int64_t>& old_trees, const SeenArea& area,
                 std::size_t trees, JudgedMap& judged) {
  MapQuality& q = judged.quality;
  std::vector<std::uint8_t> in_old_map(trees, 0);
  for (const std::int64_t tree : old_trees) {
    if (tree >= 0) in_old_map[static_cast<std::size_t>(tree)] = 1;
  }
  for (std::size_t i = 0; i < standing.places_m.size(); ++i) {
    if (!area.holds(standing.places_m[i])) continue;
    ++q.seen_trees;
    q.seen_trees_mapped += mapped[i];
    if (mapped[i] == 0) judged.unmapped_m.push_back(standing.places_m[i]);
    if (in_old_map[standing.tree[i]] != 0) continue;
    ++q.unmapped;
    q.unmapped_added += mapped[i];
  }
}

}  // namespace

JudgedMap judge_map(const MapUpdateWorld& world, const MapSnapshot& snapshot,
                    const MapUpdateSettings& updater, double gate_m) {
  const SeenArea area(world, snapshot.lists, updater);
  const auto old_trees = trees_of(world.old_map_m, world.forest.trees_m, gate_m);
  JudgedMap judged;
  MapQuality& q = judged.quality;
  q.fed_by = snapshot.fed_by;
  q.part = snapshot.part;
  q.stems_in_map = static_cast<std::int64_t>(snapshot.update.stems_in_map_m.size());
  q.lists = static_cast<std::int64_t>(snapshot.lists);
  q.accepted = snapshot.accepted;
  q.counted = snapshot.counted;
  q.update_ms = snapshot.update_ms;
  judge_old_stems(world, snapshot, old_trees, area, judged);
  const StandingTrees standing(world.forest);
  const auto mapped = judge_present_map(snapshot, standing, area, gate_m, judged);
  judge_trees(standing, mapped, old_trees, area, world.forest.trees_m.size(), judged);
  return judged;
}

}  // namespace honka::eval
