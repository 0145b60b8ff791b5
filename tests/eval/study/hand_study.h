#pragma once

#include <string>
#include <vector>

#include "eval/study/study.h"

namespace honka::test {

/// What one method made of one trial, as a law says so.
struct HandAnswer {
  double success = 1.0, wrong = 0.0;
  double error_m = 0.0, bound_m = 0.0;  ///< left out without a success
  double stems = 10.0, match_ms = 1.0;
};

/// A study of two methods, "plain" and "robust", that no runner has made: its points are those of
/// the axes.
[[nodiscard]] eval::Study hand_study(std::vector<eval::StudyAxis> axes, std::int64_t trials,
                                     std::int64_t worlds);

/// A study of one point, noise_m = 0.1.
[[nodiscard]] eval::Study hand_study(std::int64_t trials, std::int64_t worlds);

[[nodiscard]] eval::TrialRecord hand_record(eval::TrialId id, const HandAnswer& plain,
                                            const HandAnswer& robust);
[[nodiscard]] eval::TrialRecord failed_record(eval::TrialId id, eval::TrialStatus status,
                                              const std::string& cause);

/// A rows table of point 0 in which success of both methods is given trial by trial.
[[nodiscard]] eval::Table hand_table(const eval::Study& study, const std::vector<int>& plain,
                                     const std::vector<int>& robust);

}  // namespace honka::test
