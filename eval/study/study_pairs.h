#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/paired_rates.h"
#include "eval/study/study_statistics.h"

namespace honka::eval {

/// One method against another on the same trials.
struct PairedFigure {
  std::optional<std::int64_t> point;                ///< nothing: all points together
  std::size_t measure = 0;                          ///< the first rate, or an error
  std::size_t first = 0, second = 0;                ///< methods
  std::optional<double> first_value, second_value;  ///< rates; RMSE over the trials with both
  std::optional<double> difference;                 ///< second − first
  std::optional<Interval> interval;                 ///< 95 %
  std::int64_t n = 0, of = 0;                       ///< trials compared, of all
  std::optional<PairedCounts> counts;               ///< of a rate
  std::optional<double> mcnemar;                    ///< exact probability, of a rate at one point
  std::optional<std::size_t> better;                ///< the method, where a difference is seen
};

/// Every two methods, over all points and then at each: the first rate, and the errors but for the
/// bound. Empty for one method.
///
/// A difference is seen where ten trials or more are compared, the interval leaves out 0 and, for a
/// rate at one point, McNemar's exact probability is below 0.05 too.
[[nodiscard]] std::vector<PairedFigure> compare_methods(const Study& study, const Table& trials,
                                                        const std::vector<StudyCell>& cells,
                                                        StudyDraws& draws);

/// "consensus succeeds more often than li2020: +12.5 % [8.1, 17.0], n 200", or "no difference
/// seen …".
[[nodiscard]] std::string verdict_of(const Study& study, const PairedFigure& pair);

}  // namespace honka::eval
