#include "eval/run/slam/link_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

struct LinkPanel {
  const char* y_label;
  bool logarithmic;
  LinkScores::Figure ours, floor;  ///< floor may be empty
};

std::array<LinkPanel, 3> link_panels() {
  return {{{"ATE in plan (m)", true, [](const LinkRow& r) { return r.quality.ate_planar_m; }, {}},
           {"cluster RMSE (m)", true, [](const LinkRow& r) { return r.quality.cluster_rmse_m; },
            [](const LinkRow& r) { return r.floor.cluster_rmse_m; }},
           {"true stems in the map", false,
            [](const LinkRow& r) { return double(r.quality.stems_mapped); },
            [](const LinkRow& r) { return double(r.floor.stems_mapped); }}}};
}

struct LinkCurve {
  std::string label;
  std::vector<const LinkScores*> points;
};

/// One a method and variant, in the order in which they come.
std::vector<LinkCurve> curves_of(const std::string& series, const std::vector<LinkScores>& scores) {
  std::vector<LinkCurve> curves;
  for (const LinkScores& s : scores) {
    if (s.link.series != series) continue;
    const std::string label = s.method + ", " + s.link.variant;
    auto known = std::find_if(curves.begin(), curves.end(),
                              [&](const LinkCurve& curve) { return curve.label == label; });
    if (known == curves.end()) known = curves.insert(curves.end(), {label, {}});
    known->points.push_back(&s);
  }
  return curves;
}

/// Percent, mean, low and high of a figure along a curve; low = high = mean for a single drive.
std::vector<std::vector<double>> columns_of(const LinkCurve& curve,
                                            const LinkScores::Figure& figure) {
  std::vector<std::vector<double>> columns(4);
  for (const LinkScores* s : curve.points) {
    const double mean = s->mean_of(figure);
    const auto interval = s->interval_of(figure).value_or(Interval{mean, mean});
    columns[0].push_back(100.0 * s->link.value);
    columns[1].push_back(mean);
    columns[2].push_back(interval.low);
    columns[3].push_back(interval.high);
  }
  return columns;
}

std::string tics_of(const std::vector<LinkCurve>& curves) {
  std::string tics;
  if (curves.empty()) return tics;
  for (const LinkScores* s : curves.front().points) {
    const std::string percent = fmt::format("{:g}", 100.0 * s->link.value);
    tics += (tics.empty() ? "" : ", ") + gnuplot_text(percent) + " " + percent;
  }
  return tics;
}

/// A logarithmic axis that ends a little beyond the points.
std::string range_of(const std::vector<LinkCurve>& curves) {
  if (curves.empty()) return "set xrange [1:100]";
  const auto& points = curves.front().points;
  const auto [least, most] = std::minmax_element(
      points.begin(), points.end(),
      [](const LinkScores* a, const LinkScores* b) { return a->link.value < b->link.value; });
  return "set xrange [" + number(80.0 * (*least)->link.value) + ":" +
         number(125.0 * (*most)->link.value) + "]";
}

void draw_panel(Figure& figure, const LinkPanel& panel, const std::vector<LinkCurve>& curves,
                bool with_key) {
  std::vector<std::string> elements;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const std::string look = " lw 1.6 pt " + series_point(i) + " lc " + series_colour(i);
    const std::string block = figure.data(curves[i].label + ": percent, mean, low, high",
                                          columns_of(curves[i], panel.ours));
    elements.push_back(block + " using 1:2 with lines" + look + " notitle");
    elements.push_back(block + " using 1:2:3:4 with yerrorbars ps 0.8" + look +
                       (with_key ? " title " + gnuplot_text(curves[i].label) : " notitle"));
    if (!panel.floor) continue;
    const std::string floor = figure.data(curves[i].label + ": percent, mean at true poses",
                                          columns_of(curves[i], panel.floor));
    elements.push_back(floor + " using 1:2 with lines lw 1 dt 3 lc " + series_colour(i) +
                       " notitle");
  }
  figure << "set ylabel " + gnuplot_text(panel.y_label)
         << (panel.logarithmic ? "set logscale y\nset yrange [*:*]"
                               : "unset logscale y\nset yrange [0:*]");
  if (!elements.empty()) figure.plot(elements);
}

}  // namespace

ReportFigure draw_link_quality(const std::filesystem::path& folder, const std::string& series,
                               const std::vector<LinkScores>& scores) {
  const auto curves = curves_of(series, scores);
  const auto panels = link_panels();
  const bool is_bandwidth = series == "bandwidth";
  const std::string title = "Map quality against " + series;
  const std::size_t drives = curves.empty() ? 0 : curves.front().points.front()->trials.size();
  const std::string protocol = fmt::format(
      "mean over drives: {}, 95 % intervals; dotted: the same frames at true poses", drives);
  Figure figure(folder, "quality_" + series, 1000, 250 * static_cast<int>(panels.size()) + 60);
  figure << "set multiplot layout " + std::to_string(panels.size()) + ",1 title " +
                gnuplot_text(title + ": " + protocol) + " font ',13'"
         << "set key outside right top vertical"
         << "set lmargin 10"
         << "set rmargin 36"
         << "set xtics (" + tics_of(curves) + ")";
  figure << (is_bandwidth ? "set logscale x\nset xlabel 'bandwidth (% of the need), logarithmic'"
                          : "set xlabel 'lost on the air (%)'");
  if (is_bandwidth) figure << range_of(curves);
  for (std::size_t i = 0; i < panels.size(); ++i) draw_panel(figure, panels[i], curves, i == 0);
  figure << "unset multiplot";
  return figure.draw(
      title,
      "Error in plan of the arrived frames' positions after rigid alignment, spread of the "
      "stems' registrations, and true stems with a stem of the map within half a "
      "metre.");
}

}  // namespace honka::eval
