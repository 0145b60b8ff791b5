#pragma once

#include <cstdint>
#include <vector>

#include "algo/types/pose.h"
#include "algo/types/stem.h"
#include "eval/config/scenario.h"
#include "sim/sighting/sight.h"

namespace honka::eval {

/// A stand after its thinning, the map from before it, and a drive over its strip roads.
struct MapUpdateWorld {
  sim::MappedForest forest;  ///< every tree of the map's time; the felled ones do not stand
  StemMap old_map;           ///< an inventory or airborne map of the stand before the thinning
  std::vector<Eigen::Vector2d> old_map_m;
  /// Every standing tree and no other, each placed as in the old map or with an error like it.
  std::vector<Eigen::Vector2d> new_map_m;
  std::vector<Pose2> T_world_sensor;  ///< of every list, in the order of the drive
  std::vector<std::int64_t> road;     ///< of every list; the same one on every pass
  std::uint64_t seed = 0;

  [[nodiscard]] double felled_share() const;
};

/// The stand of a trial, thinned to a density. The digits depend on (scenario, trial, density)
/// alone; stand and old map on (scenario, trial).
[[nodiscard]] MapUpdateWorld make_map_update_world(const Scenario& scenario, std::int64_t trial,
                                                   double thinned_to_per_ha);

/// What the detector lists at the k-th place of the drive, about the sensor.
[[nodiscard]] std::vector<Eigen::Vector2d> list_at(const MapUpdateWorld& world,
                                                   const Scenario& scenario, std::size_t k);

}  // namespace honka::eval
