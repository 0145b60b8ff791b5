#pragma once

#include <string>
#include <vector>

#include "eval/report/figure_sweep.h"
#include "eval/study/study.h"

namespace honka::eval {

/// Where a point of a study stands in its figures.
struct SweepPlace {
  double x = 0.0;
  std::size_t column = 0;  ///< of its value among those of the first axis
  std::size_t curve = 0;   ///< of the second
  std::size_t slice = 0;   ///< combination of further axes: a figure of its own
};

/// How the points of a study are laid out over the axes of figures.
struct SweepPlan {
  static constexpr std::size_t kCurves = 6;  ///< as many as there are colours
  static constexpr std::size_t kSlices = 6;

  SweepAxis axis;                    ///< the first
  std::vector<std::string> columns;  ///< its values as texts
  std::string curve_label;           ///< of the second axis; empty for one axis
  std::vector<std::string> curves;   ///< its values; one empty text for one axis
  std::vector<std::string> slices;   ///< "key = value, …" of the others; one empty text for none
  std::vector<SweepPlace> places;    ///< one a point

  [[nodiscard]] bool two_axes() const { return !curve_label.empty(); }
};

/// Values that stand together in a list, and those of one axis, make one axis.
[[nodiscard]] SweepPlan plan_sweep(const Study& study);

}  // namespace honka::eval
