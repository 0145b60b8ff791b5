#include <algorithm>
#include <cmath>

#include "eval/report/figure_sweep.h"
#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

constexpr std::size_t kReadable = 14;  // cells beside each other that can hold numbers

/// Of larger grids every so many.
std::string grid_tics(const std::string& axis, const std::vector<std::string>& values) {
  std::string tics;
  const std::size_t step = 1 + (values.size() - 1) / kReadable;
  for (std::size_t k = 0; k < values.size(); k += step) {
    std::string label;
    for (const char c : values[k]) label += c == '%' ? "%%" : std::string(1, c);
    tics += (k > 0 ? ", " : "") + gnuplot_text(label) + " " + std::to_string(k);
  }
  return "set " + axis + "tics (" + tics + ")";
}

std::string grid_range(const std::string& axis, std::size_t values) {
  return "set " + axis + "range [-0.5:" + number(static_cast<double>(values) - 0.5) + "]";
}

/// The lowest share that a colour stands for: 0, or higher up where all are high.
double darkest(const HeatFigure& input) {
  double least = 100.0;
  for (const HeatPanel& panel : input.panels) {
    for (const HeatCell& cell : panel.cells) least = std::min(least, cell.percent);
  }
  return least >= 50.0 ? std::min(90.0, 10.0 * std::floor(least / 10.0)) : 0.0;
}

void draw_panel(Figure& figure, const HeatPanel& panel, double white_below, bool numbers) {
  std::vector<std::vector<double>> columns(5);
  for (const HeatCell& cell : panel.cells) {
    columns[0].push_back(static_cast<double>(cell.column));
    columns[1].push_back(static_cast<double>(cell.row));
    columns[2].push_back(cell.percent);
    columns[3].push_back(cell.low);
    columns[4].push_back(cell.high);
  }
  if (columns.front().empty()) {
    figure << "set multiplot next";
    return;
  }
  const std::string block = figure.data(panel.title + ": column, row, percent, low, high", columns);
  const std::string text =
      ":(sprintf(\"%.1f\\n%.0f – %.0f\", $3, $4, $5)) with labels font ',11' tc rgb ";
  const std::string limit = number(white_below);
  figure << "set title " + gnuplot_text(panel.title);
  std::vector<std::string> elements = {
      block +
      " using 1:2:($1-0.5):($1+0.5):($2-0.5):($2+0.5):3 with boxxyerror"
      " fs solid noborder fc palette notitle"};
  if (numbers) {
    elements.push_back(block + " using ($3<" + limit + "?$1:NaN):2" + text + "'white' notitle");
    elements.push_back(block + " using ($3<" + limit + "?NaN:$1):2" + text + "'black' notitle");
  }
  figure.plot(elements);
}

}  // namespace

ReportFigure draw_heat_map(const std::filesystem::path& folder, const HeatFigure& input) {
  constexpr double kWhiteShare = 0.55;  // of the scale: darker colours carry white text
  const std::size_t panels = input.panels.size();
  const std::size_t columns = input.columns.size(), rows = input.rows.size();
  const bool numbers = columns <= kReadable && rows <= kReadable;
  const int panel_px = 190 + std::clamp(72 * static_cast<int>(columns), 240, 1008);
  Figure figure(folder, input.name, panel_px * static_cast<int>(panels),
                190 + std::clamp(58 * static_cast<int>(rows), 180, 812));
  const double low = darkest(input);
  figure << "set multiplot layout 1," + std::to_string(panels) + " title " +
                gnuplot_text(input.title + ": " + input.protocol)
         << kHeightPalette << "unset grid" << grid_tics("x", input.columns)
         << grid_tics("y", input.rows) << grid_range("x", input.columns.size())
         << grid_range("y", input.rows.size()) << "set cbrange [" + number(low) + ":100]"
         << "set xlabel " + gnuplot_text(input.x_label)
         << "set ylabel " + gnuplot_text(input.y_label)
         << "set cblabel " + gnuplot_text(input.colour_label);
  for (const HeatPanel& panel : input.panels) {
    draw_panel(figure, panel, low + kWhiteShare * (100.0 - low), numbers);
  }
  figure << "unset multiplot";
  return figure.draw(input.title, input.caption);
}

}  // namespace honka::eval
