#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace honka::eval {

/// What a result says of how far a figure of it may stray by chance.
struct FigureSpread {
  std::optional<std::array<double, 2>> interval;  ///< 95 %, as the result gives it
  std::optional<double> trials;                   ///< that the row's rates are shares of
  std::optional<double> success_rate;             ///< of these, in [0, 1]
  std::optional<double> standard_deviation;       ///< of what the figure is the mean of
  bool is_count = false;                          ///< a whole number
};

/// How far a figure may be from its reference, absolute, above 0.
///
/// On one machine a result repeats to the last digit; another compiler or processor rounds
/// otherwise, and a match that was near its threshold falls to the other side. At the worst this is
/// another draw of the same noise. So the tolerance is what chance does to the figure:
/// - where it has a 95 % interval, the longer side of it;
/// - a rate or a count out of n trials: the longer side of Wilson's interval;
/// - a mean of errors with s.d. s over the successes: 1.96 s / √n;
/// - extremes and s.d.: 25 %; other counts: 5 %, at least 1; all else: 10 %.
[[nodiscard]] double tolerance_of(std::string_view column, double value,
                                  const FigureSpread& spread);

}  // namespace honka::eval
