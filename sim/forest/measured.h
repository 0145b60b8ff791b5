#pragma once

#include <Eigen/Geometry>

#include "algo/types/stem.h"

namespace honka::sim {

/// A measured stand moved into the site.
struct MeasuredStand {
  StemMap stems;                 ///< positions in the world frame
  Eigen::AlignedBox2d window_m;  ///< the ground that was measured, about
  double density_per_ha = 0.0;   ///< in the window
};

/// Puts the middle of the stems' window at the middle of the site. The window is the stems'
/// bounding box widened by the mean gap between a border and the outermost of n stems, (side /
/// (n − 1)). UserError for fewer than three stems, a stem that is not finite, stems on a line, or a
/// window that does not fit into the site.
[[nodiscard]] MeasuredStand centred(const StemMap& stems, const Eigen::AlignedBox2d& site_m);

}  // namespace honka::sim
