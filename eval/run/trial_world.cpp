#include "eval/run/trial_world.h"

#include "algo/types/random.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"

namespace honka::eval {

TrialWorld make_trial_world(const Scenario& scenario, std::int64_t trial) {
  TrialWorld world;
  world.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "trial",
                           {static_cast<std::uint64_t>(trial)});
  const Eigen::AlignedBox2d extent(
      Eigen::Vector2d::Zero(), Eigen::Vector2d(scenario.forest.width_m, scenario.forest.length_m));
  const double spacing_m = scenario.map.strip_road_spacing_m;
  world.prior_path = sim::prior_run_path(extent, spacing_m);
  world.work_path = sim::work_path(extent, scenario.protocol.path_length_m, world.seed);
  const StemMap* measured = scenario.measured ? &*scenario.measured : nullptr;
  world.stand =
      sim::make_stand(scenario.forest, {world.prior_path, world.work_path}, world.seed, measured);
  world.surfaces =
      std::make_unique<sim::World>(sim::make_world(world.stand, scenario.forest, world.seed));
  world.lidar = std::make_unique<sim::LidarSimulator>(*world.surfaces, scenario.lidar, world.seed);
  return world;
}

StemMap true_stems(const sim::Stand& stand) {
  StemMap stems;
  for (const sim::Tree& tree : stand.trees) {
    Stem stem;
    stem.position_m = sim::stem_centre_m(tree, kStemReferenceHeight_m);
    stem.z_m = tree.base_m.z();
    stem.dbh_m = tree.dbh_m;
    stem.height_m = tree.height_m;
    stems.push_back(stem);
  }
  return stems;
}

}  // namespace honka::eval
