#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "eval/metrics/trajectory_errors.h"

namespace honka::eval {

/// What `honka evaluate` has found, for its figures.
struct EvaluationPlots {
  const PosePairs& pairs;  ///< aligned
  const TrajectoryErrors& absolute;
  std::span<const Motion> motions;
  const TrajectoryErrors& relative;  ///< one a motion
  std::string protocol;              ///< alignment, pairs
  std::string motion_text;           ///< "over 1 s, from every pose"
  bool has_times = true;             ///< false: the x axis counts poses
};

/// Draws trajectory.svg, ape.svg and rpe.svg into a folder, each with its .gp and .dat. Says on the
/// error stream where they lie, or why one could not be drawn.
void plot_evaluation(const std::filesystem::path& folder, const EvaluationPlots& input);

}  // namespace honka::eval
