#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "algo/types/random.h"
#include "sim/forest/corridor_mask.h"

namespace honka::sim {

using Points = std::vector<Eigen::Vector2d>;

/// Where a spacing process may place stems, how many, and what stands there already. Opposite sides
/// of the box count as neighbours, so that stems do not crowd along its border. Metres.
struct SpacingDomain {
  Eigen::AlignedBox2d box_m;
  CorridorMask corridors;
  Eigen::AlignedBox2d window_m;  ///< of measured stems, closed to others; empty when none
  Points fixed_m;                ///< stems that stand already and are not moved
  std::int64_t count = 0;        ///< stems to place
  double spacing_m = 1.0;        ///< s = 1 / √density over the ground that is free

  [[nodiscard]] bool is_free(const Eigen::Vector2d& position_m) const {
    return box_m.contains(position_m) && !window_m.contains(position_m) &&
           !corridors.contains(position_m);
  }
  /// A uniform free place. UserError when corridors and window leave none.
  [[nodiscard]] Eigen::Vector2d draw(RandomStream& stream) const;
  /// The same place inside the box, by whole widths and lengths of it.
  [[nodiscard]] Eigen::Vector2d wrapped(const Eigen::Vector2d& position_m) const;
};

/// Ground that is free, on a raster of `step_m`. Square metres.
[[nodiscard]] double free_area_m2(const SpacingDomain& domain, double step_m = 0.5);

}  // namespace honka::sim
