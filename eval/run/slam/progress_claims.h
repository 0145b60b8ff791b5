#pragma once

#include <string>
#include <vector>

#include "eval/run/slam/progress_record.h"

namespace honka::eval {

/// A claim of the paper's text, judged on one side's tracks.
struct ProgressClaim {
  std::string claim, side;
  std::string paper;         ///< what the paper says, in figures where it has them
  std::string ours;          ///< what came out
  std::int64_t held_in = 0;  ///< trials in which it held …
  std::int64_t trials = 0;   ///< … of so many in which it could be judged
  std::string criterion;     ///< when it counts as held
};

/// "Minima together", "step error stable", "d 1.4 → 1 → 0.3", "diverges without an end condition".
[[nodiscard]] std::vector<ProgressClaim> judge_claims(const std::vector<ProgressTrack>& tracks);

/// Spearman's rank correlation of β and e_C over the points where both were measured; NaN for fewer
/// than three.
[[nodiscard]] double rank_correlation(const ProgressTrack& track);

}  // namespace honka::eval
