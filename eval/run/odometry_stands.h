#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/trial_world.h"
#include "sim/forest/thinning.h"

namespace honka::eval {

/// A stand of the odometry experiment.
struct NamedStand {
  std::string name;
  std::string differs;  ///< in words, from the scenario's forest
  double path_length_m = 0.0;
  sim::ForestSettings forest;
  std::optional<sim::ThinningSettings> thinning;
};

/// The stands that the scenario asks for (keys stands.*), in one order.
[[nodiscard]] std::vector<NamedStand> stands_of(const Scenario& scenario);

/// The world of a trial in this stand. Stands of one path length have the same path.
[[nodiscard]] TrialWorld make_stand_world(const Scenario& scenario, const NamedStand& stand,
                                          std::int64_t trial);

}  // namespace honka::eval
