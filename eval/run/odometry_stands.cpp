#include "eval/run/odometry_stands.h"

#include <fmt/format.h>

#include "sim/forest/forest.h"

namespace honka::eval {

std::vector<NamedStand> stands_of(const Scenario& scenario) {
  const StandsSettings& s = scenario.stands;
  const NamedStand same{"default", "the scenario's forest", s.path_length_m, scenario.forest, {}};
  std::vector<NamedStand> stands;
  // Adds a copy of the scenario's forest for the caller to change.
  const auto add = [&](const std::string& name, const std::string& differs) -> NamedStand& {
    stands.push_back(same);
    stands.back().name = name;
    stands.back().differs = differs;
    return stands.back();
  };
  if (s.plain.run) {
    add(same.name, same.differs).path_length_m = scenario.protocol.path_length_m;
  }
  if (s.open.run) {
    add("open", fmt::format("{} stems/ha", s.open.density_per_ha)).forest.density_per_ha =
        s.open.density_per_ha;
  }
  if (s.dense.run) {
    add("dense", fmt::format("{} stems/ha", s.dense.density_per_ha)).forest.density_per_ha =
        s.dense.density_per_ha;
  }
  if (s.thinned.run) {
    add("thinned", fmt::format("thinned to {} stems/ha", s.thinned.left_per_ha)).thinning =
        sim::ThinningSettings{.target_density_per_ha = s.thinned.left_per_ha};
  }
  if (s.undergrowth_rich.run) {
    auto& undergrowth = add("undergrowth_rich", fmt::format("{} bushes/ha and {} saplings/ha",
                                                            s.undergrowth_rich.bushes_per_ha,
                                                            s.undergrowth_rich.saplings_per_ha))
                            .forest.undergrowth;
    undergrowth.bushes_per_ha = s.undergrowth_rich.bushes_per_ha;
    undergrowth.saplings_per_ha = s.undergrowth_rich.saplings_per_ha;
  }
  if (s.steep.run) {
    add("steep", fmt::format("a slope of {}°", s.steep.slope_deg)).forest.terrain.slope_deg =
        s.steep.slope_deg;
  }
  return stands;
}

TrialWorld make_stand_world(const Scenario& scenario, const NamedStand& stand, std::int64_t trial) {
  Scenario changed = scenario;
  changed.forest = stand.forest;
  changed.protocol.path_length_m = stand.path_length_m;
  TrialWorld world = make_trial_world(changed, trial);
  if (!stand.thinning) return world;
  world.stand = sim::thin(world.stand, *stand.thinning, world.seed);
  world.surfaces =
      std::make_unique<sim::World>(sim::make_world(world.stand, changed.forest, world.seed));
  world.lidar = std::make_unique<sim::LidarSimulator>(*world.surfaces, changed.lidar, world.seed);
  return world;
}

}  // namespace honka::eval
