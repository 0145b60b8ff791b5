#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "eval/run/check/figures.h"

namespace honka::eval {

/// A figure that is not what its reference says.
struct FigureDifference {
  CheckFigure reference;
  std::string now;  ///< its value, or "not there"
};

/// Results held against a reference.
struct FigureComparison {
  std::vector<FigureDifference> outside;  ///< in the order of the reference
  std::size_t figures = 0;                ///< compared
  std::size_t added = 0;                  ///< that the reference does not know
};

/// Every figure of the reference must be among `now` and within its tolerance; words must be the
/// same. A trajectory's error may be smaller by any amount.
[[nodiscard]] FigureComparison compare_figures(const std::vector<CheckFigure>& reference,
                                               const std::vector<CheckFigure>& now);

/// Differences as lines of a table: figure, reference, tolerance, now.
[[nodiscard]] std::string differences_text(const std::vector<FigureDifference>& differences);

}  // namespace honka::eval
