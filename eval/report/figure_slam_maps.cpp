#include "eval/report/figure_slam_maps.h"

#include <algorithm>

#include "eval/report/gnuplot.h"
#include "eval/report/plot_points.h"

namespace honka::eval {
namespace {

using SlamRange = std::pair<double, double>;

constexpr int kMapWidth_px = 1100;

/// What nearly all points of all panels lie in; a few far ones do not set the scale.
SlamRange range_of(const std::vector<SlamMapPanel>& panels, int axis) {
  std::vector<double> values;
  for (const SlamMapPanel& panel : panels) {
    for (const Eigen::Vector3d& point : panel.points_m) values.push_back(point[axis]);
  }
  const SlamRange range = quantile_range(std::move(values), 0.005, 0.995);
  return {range.first - 3.0, range.second + 3.0};
}

std::string range_text(const char* axis, const SlamRange& range) {
  return std::string("set ") + axis + "range [" + number(range.first) + ":" + number(range.second) +
         "]";
}

void draw_map_panel(Figure& figure, const SlamMapPanel& panel) {
  constexpr std::size_t kMost = 120000;
  figure << "set title " + gnuplot_text(panel.label) + " font ',12'";
  const std::string points = figure.data(panel.label + ": registrations, x y z",
                                         columns_of(thinned(panel.points_m, kMost)));
  const std::string path = figure.data(panel.label + ": path, x y", panel.path_m);
  figure.plot({points + " using 1:2 with dots lc " + kBlack + " notitle",
               path + " with lines lw 2 lc " + kRed + " notitle"});
}

}  // namespace

ReportFigure draw_slam_maps(const std::filesystem::path& folder, const SlamMapsFigure& input) {
  const SlamRange x = range_of(input.panels, 0), y = range_of(input.panels, 1);
  const double shape =
      std::clamp((y.second - y.first) / std::max(1.0, x.second - x.first), 0.2, 1.5);
  const auto panels = static_cast<int>(std::max<std::size_t>(1, input.panels.size()));
  const int height = 70 + panels * static_cast<int>(60.0 + (kMapWidth_px - 90) * shape);
  Figure figure(folder, input.name, kMapWidth_px, height, Figure::Format::kPng);
  figure << "set multiplot layout " + std::to_string(panels) + ",1 title " +
                gnuplot_text(input.title + ": " + input.protocol) + " font ',13'"
         << "set size ratio -1"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'" << range_text("x", x) << range_text("y", y);
  for (const SlamMapPanel& panel : input.panels) draw_map_panel(figure, panel);
  figure << "unset multiplot";
  return figure.draw(input.title, input.caption);
}

}  // namespace honka::eval
