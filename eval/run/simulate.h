#pragma once

#include <cstdint>
#include <filesystem>

#include "eval/config/scenario.h"

namespace honka::eval {

struct SimulateOutcome {
  std::int64_t sweeps = 0, shots = 0, returns = 0;
};

/// Records every sweep of a part of a drive (scenario keys `simulate.*`, trial 0) with its truth.
/// UserError when the file cannot be written or the part lies beyond the end of the drive.
[[nodiscard]] SimulateOutcome simulate(const ResolvedScenario& resolved,
                                       const std::filesystem::path& out, int threads);

}  // namespace honka::eval
