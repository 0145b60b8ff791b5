#include "eval/run/slam/slam_world.h"

#include <algorithm>

#include "algo/types/random.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"

namespace honka::eval {

SlamWorld make_slam_world(const Scenario& scenario, std::int64_t trial) {
  SlamWorld world;
  world.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "slam_trial",
                           {static_cast<std::uint64_t>(trial)});
  const Eigen::AlignedBox2d strip(
      Eigen::Vector2d::Zero(), Eigen::Vector2d(scenario.forest.width_m, scenario.forest.length_m));
  world.road = sim::work_path(strip, scenario.protocol.path_length_m, world.seed);
  world.stand = sim::make_stand(scenario.forest, {world.road}, world.seed);
  world.surfaces =
      std::make_unique<sim::World>(sim::make_world(world.stand, scenario.forest, world.seed));
  world.lidar = std::make_unique<sim::LidarSimulator>(*world.surfaces, scenario.lidar, world.seed);
  return world;
}

std::int64_t trees_on_strip(const sim::Stand& stand) {
  return std::count_if(stand.trees.begin(), stand.trees.end(), [&](const sim::Tree& tree) {
    return stand.extent_m.contains(Eigen::Vector2d(tree.base_m.head<2>()));
  });
}

}  // namespace honka::eval
