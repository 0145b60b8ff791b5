#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "sim/world/polyline.h"

namespace honka::sim {

/// Radius that a folding-frame machine of 7.6 m turns on with room to spare.
inline constexpr double kTurningRadius_m = 10.0;

/// Straight roads `spacing_m` apart along the longer side, through the whole extent and centred in
/// it: 200 × 300 m at 50 m gives 4 roads of 300 m, the preprint's 1,200 m (Li 2020).
[[nodiscard]] std::vector<Polyline> strip_roads(const Eigen::AlignedBox2d& extent,
                                                double spacing_m);

/// One drive over all strip roads, to and fro. The turns (two arcs of `turning_radius_m` and the
/// way between) lie beyond the extent's edge, so that the part inside is the roads alone.
[[nodiscard]] Polyline prior_run_path(const Eigen::AlignedBox2d& extent, double spacing_m,
                                      double turning_radius_m = kTurningRadius_m);

/// A winding path of `length_m` in the middle of the extent, at least 40 m from its edges where it
/// fits (then as far as it does). Its heading, bends and direction are drawn from `seed`; no bend
/// is tighter than kTurningRadius_m. Points every half metre.
[[nodiscard]] Polyline work_path(const Eigen::AlignedBox2d& extent, double length_m,
                                 std::uint64_t seed);

}  // namespace honka::sim
