#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "algo/types/stem.h"
#include "eval/config/scenario.h"
#include "sim/forest/stand.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/world/world.h"

namespace honka::eval {

/// A stand at one time, and the sensor that sees it.
struct SeenStand {
  sim::Stand stand;
  std::unique_ptr<sim::World> surfaces;
  std::unique_ptr<sim::LidarSimulator> lidar;
};

/// The world of one trial: a stand, the ways through it, and the sensor that sees it.
struct TrialWorld : SeenStand {
  std::uint64_t seed = 0;    ///< of the trial
  sim::Polyline prior_path;  ///< of the run that makes the map
  sim::Polyline work_path;   ///< of the run that is localized
  /// The stand as the prior run saw it, where `map.thinned_to_per_ha` puts a thinning between the
  /// runs; the members above are then what the thinning left.
  std::optional<SeenStand> before_thinning;

  [[nodiscard]] const SeenStand& when_mapped() const {
    return before_thinning ? *before_thinning : *this;
  }
};

/// Grows the stand of a trial, lays the roads, and builds the scene. The digits depend on the
/// scenario's seed and the trial alone.
[[nodiscard]] TrialWorld make_trial_world(const Scenario& scenario, std::int64_t trial);

/// Height above ground at which a true stem's place is taken: between the 0.4 and 7 m that scans
/// of stems cover, near the sensor's.
inline constexpr double kStemReferenceHeight_m = 2.0;

/// The true stems of a stand in the world frame, in the order of its trees.
[[nodiscard]] StemMap true_stems(const sim::Stand& stand);

}  // namespace honka::eval
