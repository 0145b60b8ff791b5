#include "eval/run/trial_world.h"

#include "algo/types/random.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"

namespace honka::eval {

namespace {

SeenStand seen(sim::Stand stand, const Scenario& scenario, std::uint64_t seed) {
  SeenStand result;
  result.stand = std::move(stand);
  result.surfaces =
      std::make_unique<sim::World>(sim::make_world(result.stand, scenario.forest, seed));
  result.lidar = std::make_unique<sim::LidarSimulator>(*result.surfaces, scenario.lidar, seed);
  return result;
}

}  // namespace

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
  sim::Stand stand =
      sim::make_stand(scenario.forest, {world.prior_path, world.work_path}, world.seed, measured);
  if (scenario.map.thinned_to_per_ha > 0.0) {
    world.before_thinning = seen(stand, scenario, world.seed);
    sim::ThinningSettings thinning;
    thinning.target_density_per_ha = scenario.map.thinned_to_per_ha;
    thinning.strip_road_spacing_m = scenario.map.strip_road_spacing_m;
    stand = sim::thin(stand, thinning, world.seed);
  }
  static_cast<SeenStand&>(world) = seen(std::move(stand), scenario, world.seed);
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
