#pragma once

#include <cstdint>

#include "algo/slam/sparse_frame.h"
#include "eval/run/experiment.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// A drive, and the chain of its key frames that the loop starts from.
struct ImprovementStart {
  SlamDrive drive;
  FramePoses T_first_frame;
  std::uint64_t seed = 0;  ///< of the loop's random choices
};
[[nodiscard]] ImprovementStart improvement_start(const RunRequest& request, std::int64_t trial);

}  // namespace honka::eval
