#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/study/study_statistics.h"

namespace honka::eval {

/// The widest interval of the first rate of a method over all points, had each ended after so many
/// trials (or where it did end, when that was before).
struct ConvergenceFigure {
  std::int64_t trials = 0;
  std::size_t method = 0;
  std::int64_t point = 0;  ///< where it is that wide
  RateFigure rate;
};

struct Convergence {
  std::vector<ConvergenceFigure> curve;      ///< by trials, then method
  std::int64_t fewest = 0, most = 0;         ///< trials at a point
  std::optional<ConvergenceFigure> widest;   ///< after all trials, of all methods
  std::optional<std::int64_t> trials_for_1;  ///< at which ±1 % is to be expected, where not yet
};

/// Trials are taken in the order of their numbers.
[[nodiscard]] Convergence convergence_of(const Study& study, const Table& trials,
                                         const std::vector<StudyCell>& cells);

/// "±1.2 % after 800 trials (…); ±1 % wants about 1,150 trials at each point".
[[nodiscard]] std::string convergence_line(const Study& study, const Convergence& convergence);

}  // namespace honka::eval
