#include "sim/sighting/slope.h"

#include <cmath>

#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// A place of the plan, along the ground.
Eigen::Vector2d along_ground(const Eigen::Vector2d& place_m, double slope_rad) {
  return {place_m.x() / std::cos(slope_rad), place_m.y()};
}

}  // namespace

SlopedForest::SlopedForest(const MappedForest& in_plan, double slope) : slope_rad(slope) {
  along.box_m = Eigen::AlignedBox2d(along_ground(in_plan.box_m.min(), slope),
                                    along_ground(in_plan.box_m.max(), slope));
  for (const Eigen::Vector2d& tree : in_plan.trees_m) {
    along.trees_m.push_back(along_ground(tree, slope));
  }
  along.standing = in_plan.standing;
  along.in_map = in_plan.in_map;
  along.near = std::make_unique<KdTree2>(along.trees_m);
}

double SlopedForest::height_m(const Eigen::Vector2d& place_m) const {
  return place_m.x() * std::tan(slope_rad);
}

Pose3 SlopedForest::T_world_ground() const {
  return pose_from_rpy(Eigen::Vector3d::Zero(), 0.0, -slope_rad, 0.0);
}

Pose3 SlopedForest::T_world_sensor(const Pose2& place) const {
  const Eigen::Vector2d& plan_m = place.translation_m;
  Pose3 T = T_world_ground() * pose_from_rpy(Eigen::Vector3d::Zero(), 0.0, 0.0, place.yaw_rad);
  T.translation() << plan_m, height_m(plan_m);
  return T;
}

SlopeSighting sight_on_slope(const SlopedForest& forest, const Pose2& place,
                             const SightingSettings& settings, double height_noise_m,
                             std::uint64_t seed, std::uint64_t query) {
  const Pose2 T_ground_sensor{along_ground(place.translation_m, forest.slope_rad), place.yaw_rad};
  const Sighting list = sight(forest.along, T_ground_sensor, settings, seed, query);
  SlopeSighting on_slope{forest.T_world_sensor(place), {}, list.trees};
  for (std::size_t i = 0; i < list.trees.size(); ++i) {
    // Of a tree by its number, of what is none by its place in the list.
    const bool tree = list.trees[i] >= 0;
    const auto number = tree ? static_cast<std::uint64_t>(list.trees[i]) : i;
    RandomStream stream(seed, tree ? "sighting_height" : "sighting_false_height", {query, number});
    const Eigen::Vector2d& foot_m = list.stems_in_sensor_m[i];
    on_slope.stems_in_sensor_m.emplace_back(foot_m.x(), foot_m.y(),
                                            stream.normal(0.0, height_noise_m));
  }
  return on_slope;
}

}  // namespace honka::sim
