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
  sim::ForestSettings forest;
  std::optional<sim::ThinningSettings> thinning;
};

/// The stands that the scenario asks for (keys stands.*), in one order.
[[nodiscard]] std::vector<NamedStand> stands_of(const Scenario& scenario);

/// The world of a trial in this stand. Paths are the same in all stands of a trial.
[[nodiscard]] TrialWorld make_stand_world(const Scenario& scenario, const NamedStand& stand,
                                          std::int64_t trial);

}  // namespace honka::eval
