#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "algo/slam/slam.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// Corrections from one measuring of e_C to the next.
inline constexpr std::int64_t kNoiseEvery = 5;

/// What a map is like. NaN where a figure was not measured or cannot be had.
struct MapFigures {
  double blur = std::numeric_limits<double>::quiet_NaN();            ///< β
  double cluster_rmse_m = std::numeric_limits<double>::quiet_NaN();  ///< e_C, link 0.5 m, mean
  double dimension = std::numeric_limits<double>::quiet_NaN();       ///< box counting, 0.2–3.2 m
  double two_scale_dimension = std::numeric_limits<double>::quiet_NaN();  ///< 0.2 and 10 m
  double step_error_m = std::numeric_limits<double>::quiet_NaN();  ///< mean e of the chain's steps
  double ate_m = std::numeric_limits<double>::quiet_NaN();  ///< RMSE of positions, rigidly aligned
};

/// The map after one of the loop's corrections; the first of a track is the start.
struct ProgressPoint {
  std::int64_t round = 0;    ///< 1 for the first; 0 at the start
  std::int64_t tried = 0;    ///< pairs so far
  std::int64_t applied = 0;  ///< corrections so far
  std::int64_t go_icp_calls = 0;
  MapFigures map;
};

/// The loop over all its rounds, from one side of the update.
struct ProgressTrack {
  std::int64_t trial = 0;
  std::string side;
  std::vector<ProgressPoint> points;
  MapFigures floor;  ///< of the same frames at their true poses
  std::size_t frames = 0;

  /// The last point of a round; the start for 0.
  [[nodiscard]] const ProgressPoint& end_of_round(std::int64_t round) const;
};

/// Runs the paper's loop (settings.loop, settings.view) from `T_first_frame` and measures the map
/// after each correction; e_C at the end of each round and after every fifth correction.
[[nodiscard]] ProgressTrack record_progress(const SlamDrive& drive, const FramePoses& T_first_frame,
                                            const SlamSettings& settings, const std::string& side,
                                            std::uint64_t seed);

}  // namespace honka::eval
