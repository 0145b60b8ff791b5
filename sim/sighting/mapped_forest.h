#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

#include "algo/geometry/kdtree.h"
#include "algo/types/pose.h"
#include "sim/forest/spacing/registry.h"
#include "sim/sighting/settings.h"

namespace honka::sim {

/// Trees as points in a square, and the stem map that was made of them. Truth: matchers get
/// `map_m` alone.
struct MappedForest {
  Eigen::AlignedBox2d box_m;
  Points trees_m;
  std::vector<std::uint8_t> standing;  ///< of each tree: 0 felled since the map was made
  std::vector<std::uint8_t> in_map;    ///< of each tree
  Points map_m;                        ///< the trees in the map, with its noise, in their order
  std::unique_ptr<KdTree2> near;       ///< over trees_m

  MappedForest() = default;
  MappedForest(MappedForest&&) = default;
  MappedForest& operator=(MappedForest&&) = delete;
};

/// `mapping.stems` trees by a spacing process at a density, in a square about the origin, and their
/// map; more than 10,000 in tiles of at most so many. The digits depend on (settings, seed) alone.
/// UserError when the trees do not fit.
[[nodiscard]] std::unique_ptr<MappedForest> make_mapped_forest(const SpacingSettings& spacing,
                                                               double density_per_ha,
                                                               const MappingSettings& mapping,
                                                               std::uint64_t seed);

/// A place for a sensor, by the stream (seed, "sighting_pose", {query}): uniform over the box but
/// for a border, any heading, no standing tree within a metre. UserError where there is none.
[[nodiscard]] Pose2 draw_pose(const MappedForest& forest, double border_m, std::uint64_t seed,
                              std::uint64_t query);

}  // namespace honka::sim
