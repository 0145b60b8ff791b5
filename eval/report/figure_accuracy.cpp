#include "eval/report/figure_accuracy.h"

#include <algorithm>
#include <cmath>

#include "eval/report/gnuplot.h"
#include "eval/report/plot_points.h"

namespace honka::eval {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// (error, log10 time) of the windows in which both are known.
Points in_log_time(const std::vector<double>& errors_deg, const std::vector<double>& times_s) {
  Points points;
  for (std::size_t i = 0; i < std::min(errors_deg.size(), times_s.size()); ++i) {
    if (std::isfinite(errors_deg[i]) && times_s[i] > 0.0) {
      points.emplace_back(errors_deg[i], std::log10(times_s[i]));
    }
  }
  return points;
}

Points in_seconds(Points points) {
  for (auto& point : points) point.y() = std::pow(10.0, point.y());
  return points;
}

/// Cloud, ellipse and label of one kind of time for one number of frames.
void add_series(Figure& figure, std::vector<std::string>& elements, const Points& points,
                const std::string& name, std::size_t i, bool map_time) {
  if (points.empty()) return;
  const std::string colour = map_time ? kBlack : series_colour(i);
  const Ellipse ellipse = two_sd_ellipse(points);
  const std::string cloud = figure.data(name + ": rotation error deg, time s", in_seconds(points));
  elements.push_back(cloud + " with points pt " + (map_time ? "6" : "7") + " ps 0.3 lc rgb " +
                     (map_time ? "'#999999'" : colour) + " notitle");
  const std::string ring = figure.data(name + ": 2 s.d. ellipse", in_seconds(outline(ellipse)));
  elements.push_back(ring + " with lines lw 2 " + (map_time ? "dt 2 " : "") + "lc rgb " + colour +
                     " notitle");
  const Points top = in_seconds(outline(ellipse, 4));
  const auto right = std::max_element(top.begin(), top.end(),
                                      [](const auto& a, const auto& b) { return a.x() < b.x(); });
  figure << "set label " + gnuplot_text(name.substr(0, name.find(' '))) + " at " +
                number(right->x()) + "," + number(right->y()) +
                " left offset 0.4,0 front font ',11' tc rgb " + colour;
}

}  // namespace

ReportFigure draw_accuracy(const std::filesystem::path& folder, const AccuracyFigure& input) {
  Figure figure(folder, "accuracy", 900, 620);
  figure.title("Rotation error against computing time", input.protocol);
  std::vector<std::string> elements;
  double largest = 0.1;
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    const AccuracySeries& series = input.series[i];
    const std::string label = frames_label(series.frames);
    const Points match = in_log_time(series.rotation_error_deg, series.match_time_s);
    const Points map = in_log_time(series.rotation_error_deg, series.map_time_s);
    for (const auto& point : match) largest = std::max(largest, point.x());
    add_series(figure, elements, map, label + " local map", i, true);
    add_series(figure, elements, match, label + " matching", i, false);
  }
  elements.push_back("NaN with lines lw 2 dt 2 lc rgb " + std::string(kBlack) +
                     " title 'local map creation, 2 s.d. (86.5 %)'");
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    elements.push_back(
        "NaN with lines lw 2 lc rgb " + series_colour(i) + " title " +
        gnuplot_text("matching " + frames_label(input.series[i].frames) + ", 2 s.d. (86.5 %)"));
  }
  figure << "set logscale y"
         << "set format y '10^{%T}'"
         << "set xlabel 'rotation error (deg)'"
         << "set ylabel 'time of one localization (s)'"
         << "set xrange [0:" + number(1.15 * largest) + "]";
  figure.key_below(175);
  figure.plot(elements);
  return figure.draw(
      "Accuracy against computing time (the paper's Figure 10)",
      "Each point is a successful window; matching in colour, creation of the local map in grey "
      "and black. The ellipses hold 2 s.d. of the error and of log10 of the time, that is 86.5 % "
      "of a normal law in the plane. The paper: about 0.1 s and at most 2.23° for C1, 0.6 s for "
      "C10.");
}

}  // namespace honka::eval
