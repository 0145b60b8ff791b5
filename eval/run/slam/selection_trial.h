#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "algo/slam/correction/candidate_pairs.h"
#include "algo/slam/correction/poisson_choice.h"
#include "eval/run/slam/improvement_trials.h"

namespace honka::eval {

/// Motion of a pair counts as right within these of the true one.
inline constexpr double kRightPair_m = 0.5;
inline constexpr double kRightPair_deg = 2.5;

/// What the loop's selection makes of one drive, with one test of pairs.
struct SelectionCase {
  std::int64_t trial = 0;
  std::string test;  ///< nearest (as they lie) | icp (after an attempt)
  std::size_t frames = 0;
  CandidatePairs found;
  PoissonChoice choice;
  double overlap_limit = 0.0, error_at_no_overlap_m = 0.0, error_slope_m = 0.0;
  std::int64_t promising_right = 0, inferior_right = 0;  ///< whose judged motion is right
  std::int64_t under_line_at_truth = 0;  ///< of all judged pairs, at their true poses

  [[nodiscard]] std::int64_t judged() const {
    return static_cast<std::int64_t>(found.promising.size() + found.inferior.size());
  }
};

/// Both tests on the same start: random pairs, Eq. 27, the near-Poisson-disk choice.
[[nodiscard]] std::vector<SelectionCase> run_selection(const ImprovementStart& start,
                                                       const SlamSettings& settings,
                                                       std::int64_t trial);

}  // namespace honka::eval
