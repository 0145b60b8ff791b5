#pragma once

#include <cstdint>
#include <span>

#include "algo/slam/methods/stage_progress.h"
#include "algo/slam/methods/stem_map.h"
#include "algo/slam/sparse_frame.h"
#include "algo/types/settings.h"

namespace honka {

/// Adjustment of poses and stems together.
struct LandmarkBaSettings {
  double planar_m = 0.07;     ///< standard deviation of an observation, in x and in y
  double vertical_m = 0.10;   ///< and in z
  double robust_scale = 3.0;  ///< Cauchy loss, in standard deviations
  double chain_m = 0.2;       ///< weak tie between neighbours: it holds what no stem holds
  double chain_deg = 1.0;
  std::int64_t rounds = 2;      ///< associations, each with its own adjustment
  std::int64_t iterations = 3;  ///< Gauss–Newton steps of a round
};
void describe(SettingsVisitor& v, LandmarkBaSettings& s);

/// Adjusted poses and the stems they were adjusted with. All poses are finite.
struct LandmarkBaResult {
  FramePoses T_first_frame;
  StemMap3 map;
  double initial_cost = 0.0, final_cost = 0.0;  ///< robust, of the last round's association
  int iterations = 0;
  std::size_t free_frames = 0;  ///< frames that saw no stem: they hang on the chain alone
};

/// Moves all poses but the first, and all stems, so that the observations fit best; associates
/// again and repeats. Frames at `drive_starts` (positions, rising; the first need not be named) are
/// not tied to the one before them: there another vehicle's drive begins.
/// Source: choice, beyond Nevalainen2021.
[[nodiscard]] LandmarkBaResult adjust_landmarks(std::span<const SparseFrame> frames,
                                                const FramePoses& T_first_frame,
                                                const StemMapSettings& map_settings,
                                                const LandmarkBaSettings& settings,
                                                std::span<const std::size_t> drive_starts = {},
                                                const StageProgress& progress = {});

}  // namespace honka
