#pragma once

#include <cstdint>

#include "algo/slam/sparse_frame.h"
#include "eval/run/experiment.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// The trials that a request asks for: first, and one past the last. UserError for a --trial that
/// the scenario does not have.
struct ImprovementTrials {
  std::int64_t first = 0, end = 0;
};
[[nodiscard]] ImprovementTrials improvement_trials(const RunRequest& request);

/// A drive, and the chain of its key frames that the loop starts from.
struct ImprovementStart {
  SlamDrive drive;
  FramePoses T_first_frame;
  std::uint64_t seed = 0;  ///< of the loop's random choices
};
[[nodiscard]] ImprovementStart improvement_start(const RunRequest& request, std::int64_t trial);

}  // namespace honka::eval
