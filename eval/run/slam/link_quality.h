#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "algo/slam/methods/stem_map.h"
#include "algo/slam/sparse_frame.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// How good a map of some frames of a drive is. NaN where a figure cannot be had.
struct LinkMapQuality {
  double blur = std::numeric_limits<double>::quiet_NaN();            ///< β, 0.2 and 10 m
  double cluster_rmse_m = std::numeric_limits<double>::quiet_NaN();  ///< e_C, link 0.5 m, mean
  double ate_m = std::numeric_limits<double>::quiet_NaN();  ///< RMSE of positions, rigidly aligned
  double ate_planar_m = std::numeric_limits<double>::quiet_NaN();  ///< of it x and y of truth
  double stem_rmse_m = std::numeric_limits<double>::quiet_NaN();   ///< of mapped stems, planar
  std::int64_t stems_mapped = 0;  ///< true stems with a stem of the map within the gate
  std::int64_t stems_false = 0;   ///< stems of the map without a true one
};

/// A map's stem within this of a true one, in the plane, maps it: a seventh of the mean distance
/// between neighbours.
inline constexpr double kMappedStemGate_m = 0.5;

/// Judges the map that `T_first_frame` makes of frames of a drive (found by their numbers), and its
/// stems, once the positions are laid onto the true ones.
[[nodiscard]] LinkMapQuality judge_link_map(const SlamDrive& drive,
                                            std::span<const SparseFrame> frames,
                                            const FramePoses& T_first_frame,
                                            std::span<const MapStem> stems);

}  // namespace honka::eval
