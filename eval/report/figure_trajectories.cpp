#include "eval/report/figure_trajectories.h"

#include <algorithm>
#include <cmath>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// Width and height of what the curves cover, at least 1 each.
Eigen::Array2d size_of(const std::vector<Curve>& curves) {
  bool any = false;
  Eigen::Array2d low(0.0, 0.0), high(1.0, 1.0);
  for (const Curve& curve : curves) {
    for (const Eigen::Vector2d& point : curve.points) {
      if (!point.allFinite()) continue;
      if (!any) low = high = point.array();
      low = low.min(point.array());
      high = high.max(point.array());
      any = true;
    }
  }
  return (high - low).max(1.0);
}

/// A distance between tics, 1, 2 or 5 times a power of ten, with at most ten on so long an axis.
double tic_step(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length / 10.0)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (length / (step * power) <= 10.0) return step * power;
  }
  return 10.0 * power;
}

/// Colours of estimates; black is left to the truth.
std::string estimate_line(std::size_t i) { return " with lines lw 1.6 lc " + series_colour(i); }

void draw_curves_panel(Figure& figure, const CurvesPanel& panel, bool points) {
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    const std::string style =
        points ? " with linespoints lw 1.6 pt " + series_point(i) + " ps 0.7 lc " + series_colour(i)
               : estimate_line(i);
    elements.push_back(figure.data(curve.label, curve.points) + style + " title " +
                       gnuplot_text(curve.label));
  }
  figure << "set ylabel " + gnuplot_text(panel.y_label);
  if (!elements.empty()) figure.plot(elements);
}

}  // namespace

std::vector<Eigen::Vector2d> sampled(const std::vector<Eigen::Vector2d>& points,
                                     std::size_t limit) {
  if (points.size() <= limit || limit < 2) return points;
  std::vector<Eigen::Vector2d> chosen;
  for (std::size_t i = 0; i < limit; ++i) {
    chosen.push_back(points[i * (points.size() - 1) / (limit - 1)]);
  }
  return chosen;
}

ReportFigure draw_trajectories(const std::filesystem::path& folder,
                               const TrajectoriesFigure& input) {
  const Eigen::Array2d size = size_of(input.curves);
  const double shape = std::clamp(size.y() / size.x(), 0.35, 1.4);
  const std::string step = number(tic_step(size.maxCoeff()));  // one for both axes of equal scale
  Figure figure(folder, input.name, 900, static_cast<int>(200.0 + 760.0 * shape));
  figure.title(input.title, input.protocol);
  figure << "set size ratio -1"
         << "set xtics " + step << "set ytics " + step << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'";
  figure.key_below(115);
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < input.curves.size(); ++i) {
    const Curve& curve = input.curves[i];
    const std::string style =
        i == 0 ? std::string(" with lines lw 3.5 lc ") + kGrey : estimate_line(i - 1);
    elements.push_back(figure.data(curve.label + ": x y", curve.points) + style + " title " +
                       gnuplot_text(curve.label));
  }
  if (!elements.empty()) figure.plot(elements);
  return figure.draw(input.title, "Trajectories from above. Grey: the truth.");
}

ReportFigure draw_curves(const std::filesystem::path& folder, const CurvesFigure& input) {
  const std::size_t panels = std::max<std::size_t>(1, input.panels.size());
  Figure figure(folder, input.name, 1000, static_cast<int>(130 + 210 * panels));
  figure << "set multiplot layout " + std::to_string(panels) + ",1 title " +
                gnuplot_text(input.title + ": " + input.protocol) + " font ',14'"
         << "set xlabel " + gnuplot_text(input.x_label) << "set key outside right top vertical"
         << "set lmargin 10"
         << "set yrange [0:*]";
  for (const CurvesPanel& panel : input.panels) draw_curves_panel(figure, panel, input.points);
  figure << "unset multiplot";
  return figure.draw(input.title, input.caption);
}

}  // namespace honka::eval
