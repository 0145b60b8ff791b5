#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "eval/report/report_model.h"

namespace honka::eval {

/// What curves run over: numbers, or words at equal distances.
struct SweepAxis {
  std::string label;               ///< "sighting.noise_m (m)"
  std::vector<double> numbers;     ///< in any order; empty for words
  std::vector<std::string> words;  ///< the k-th stands at x = k
};

/// A value with its interval; NaN ends are not drawn.
struct SweepPoint {
  double x = 0.0, middle = 0.0;
  double low = std::numeric_limits<double>::quiet_NaN();
  double high = std::numeric_limits<double>::quiet_NaN();
};

struct SweepCurve {
  std::string label;       ///< empty: not in the legend
  std::size_t style = 0;   ///< colour and point type
  bool reference = false;  ///< a bound: dashed, without points
  std::vector<SweepPoint> points;
};

struct SweepPanel {
  std::string title;
  std::vector<SweepCurve> curves;
};

/// Curves with intervals over an axis, in one panel or several beside each other.
struct SweepFigure {
  std::string name, title, protocol, caption, y_label;
  std::string legend = {};  ///< what the labels of the curves are values of
  SweepAxis axis;
  std::vector<SweepPanel> panels;
  bool percent = false;  ///< of a share: the axis ends at 100
  bool log_y = false;
};

/// Numbers that span more than a factor of 20 stand on a logarithmic axis.
[[nodiscard]] ReportFigure draw_sweep(const std::filesystem::path& folder,
                                      const SweepFigure& input);

/// Shares in percent on a grid, each with its interval.
struct HeatCell {
  std::size_t column = 0, row = 0;
  double percent = 0.0, low = 0.0, high = 0.0;
};

struct HeatPanel {
  std::string title;
  std::vector<HeatCell> cells;
};

/// Maps of shares over two axes, one a method, with one scale of colours.
struct HeatFigure {
  std::string name, title, protocol, caption, x_label, y_label, colour_label;
  std::vector<std::string> columns, rows;  ///< their values, in order
  std::vector<HeatPanel> panels;
};

[[nodiscard]] ReportFigure draw_heat_map(const std::filesystem::path& folder,
                                         const HeatFigure& input);

}  // namespace honka::eval
