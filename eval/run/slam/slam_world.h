#pragma once

#include <cstdint>

#include "eval/config/scenario.h"
#include "eval/run/trial_world.h"

namespace honka::eval {

/// A strip of forest, the forest around it, and the one strip road through it.
struct SlamWorld : SeenStand {
  std::uint64_t seed = 0;  ///< of the trial
  sim::Polyline road;
};

/// The strip is the site of the scenario's forest, its long side along x; `forest.margin_m`
/// continues the stand beyond it. A winding road of protocol.path_length_m lies inside the strip,
/// and no other road is cut. The digits depend on the scenario and the trial alone.
[[nodiscard]] SlamWorld make_slam_world(const Scenario& scenario, std::int64_t trial);

/// Trees on the strip itself, the margin left out.
[[nodiscard]] std::int64_t trees_on_strip(const sim::Stand& stand);

}  // namespace honka::eval
