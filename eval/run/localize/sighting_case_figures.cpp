#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "eval/report/gnuplot.h"
#include "eval/run/localize/sighting_figures.h"

namespace honka::eval {
namespace {

using Texts = std::vector<std::string>;

Texts distinct(const std::vector<SightingSummary>& summaries, std::string SightingSummary::*what) {
  Texts texts;
  for (const SightingSummary& s : summaries) {
    if (std::find(texts.begin(), texts.end(), s.*what) == texts.end()) texts.push_back(s.*what);
  }
  return texts;
}

/// A value with its interval, by case; three columns of x, and the row.
using CaseValue = std::array<double, 3> (*)(const SightingSummary&);

std::vector<std::vector<double>> case_columns(const std::vector<SightingSummary>& summaries,
                                              const Texts& cases, const std::string& method,
                                              double shift, CaseValue value) {
  std::vector<std::vector<double>> columns(4);
  for (const SightingSummary& s : summaries) {
    if (s.method != method) continue;
    const auto place = std::find(cases.begin(), cases.end(), s.name) - cases.begin();
    const auto [middle, low, high] = value(s);
    if (std::isnan(middle)) continue;
    columns[0].push_back(middle);
    columns[1].push_back(low);
    columns[2].push_back(high);
    columns[3].push_back(static_cast<double>(place) + shift);
  }
  return columns;
}

struct CaseFigure {
  const char *name, *title, *protocol, *axis, *caption;
  CaseValue value;
  Texts settings;  ///< lines of the script
};

/// gnuplot reads a tic's label as a format: a percent sign stands twice.
std::string tic_text(const std::string& label) {
  std::string text;
  for (const char c : label) text += c == '%' ? "%%" : std::string(1, c);
  return gnuplot_text(text);
}

/// The cases from the top down, the methods beside each other in a row.
ReportFigure draw_by_case(const std::filesystem::path& folder,
                          const std::vector<SightingSummary>& summaries, const CaseFigure& what) {
  const Texts cases = distinct(summaries, &SightingSummary::name);
  const Texts methods = distinct(summaries, &SightingSummary::method);
  const int height_px = 215 + 46 * static_cast<int>(cases.size());
  Figure figure(folder, what.name, 900, height_px);
  figure.title(what.title, what.protocol);
  std::string tics;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    tics += (k > 0 ? ", " : "") + tic_text(cases[k]) + " " + std::to_string(k);
  }
  figure << "set ytics (" + tics + ") noenhanced"
         << "set yrange [" + number(static_cast<double>(cases.size()) - 0.5) + ":-0.5]"
         << "set xlabel '" + std::string(what.axis) + "'"
         << "set grid x y";
  for (const std::string& line : what.settings) figure << line;
  figure.key_below(105);
  Texts elements;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double shift = 0.24 * (static_cast<double>(m) - 0.5 * (methods.size() - 1.0));
    const auto columns = case_columns(summaries, cases, methods[m], shift, what.value);
    if (columns.front().empty()) continue;  // gnuplot refuses a block without a number
    elements.push_back(figure.data(methods[m] + ": value, low, high, row", columns) +
                       " using 1:4:2:3 with xerrorbars lw 1.8 ps 0.9 pt " + series_point(m) +
                       " lc " + series_colour(m) + " title " + gnuplot_text(methods[m]));
  }
  figure.plot(elements);
  return figure.draw(what.title, what.caption);
}

double ratio_or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

ReportFigure draw_success_by_case(const std::filesystem::path& folder,
                                  const std::vector<SightingSummary>& summaries) {
  const auto value = [](const SightingSummary& s) {
    return std::array<double, 3>{100.0 * s.share(s.successes), 100.0 * s.success_interval.low,
                                 100.0 * s.success_interval.high};
  };
  return draw_by_case(folder, summaries,
                      {"success_by_case",
                       "Success by case",
                       "one frame, no guess; Wilson intervals, 95 %",
                       "accepted and right (%)",
                       "Every list of a case counts, refused and wrong ones too.",
                       value,
                       {"set xrange [-2:102]"}});
}

ReportFigure draw_bound_by_case(const std::filesystem::path& folder,
                                const std::vector<SightingSummary>& summaries) {
  const auto value = [](const SightingSummary& s) {
    // An RMS of 2n normal components has a relative s.d. of 1/√(4n); of a few it says nothing.
    const double ratio = s.successes < 10 ? ratio_or_nan({}) : ratio_or_nan(s.error_over_bound);
    const double spread = 1.96 * ratio / std::sqrt(4.0 * std::max<double>(s.successes, 1.0));
    return std::array<double, 3>{ratio, ratio - spread, ratio + spread};
  };
  return draw_by_case(
      folder, summaries,
      {"bound_by_case",
       "Error over the Cramér-Rao bound by case",
       "RMS position error of the successes over the RMS bound; intervals for normal errors, 95 %",
       "error / bound",
       "1 is the least error that any unbiased method can have with these stems; the dashed line "
       "is 1.05.",
       value,
       {"set xrange [0.8:*]", "set arrow from 1.05, graph 0 to 1.05, graph 1 nohead dt 2 lc 'grey'",
        "set arrow from 1, graph 0 to 1, graph 1 nohead lc 'grey'"}});
}

ReportFigure draw_time_by_case(const std::filesystem::path& folder,
                               const std::vector<SightingSummary>& summaries) {
  const auto value = [](const SightingSummary& s) {
    return std::array<double, 3>{s.time_p50_ms, s.time_p50_ms, s.time_p95_ms};
  };
  return draw_by_case(folder, summaries,
                      {"time_by_case",
                       "Time of a query by case",
                       "matching alone, one thread a query; p50, whisker to p95",
                       "time (ms)",
                       "Maps are indexed beforehand.",
                       value,
                       {"set logscale x"}});
}

ReportFigure draw_time_by_size(const std::filesystem::path& folder,
                               const std::vector<SightingSummary>& summaries) {
  Figure figure(folder, "time_by_size", 860, 590);
  figure.title("Time against the size of the map", "one thread; a query: p50, whisker to p95");
  figure << "set logscale xy\nset xlabel 'stems in the map'\nset ylabel 'time (ms)'"
         << "set format x '10^{%L}'\nset format y '10^{%L}'\nset grid";
  figure.key_below(145);
  Texts elements;
  const Texts methods = distinct(summaries, &SightingSummary::method);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::vector<std::vector<double>> columns(4);
    for (const SightingSummary& s : summaries) {
      if (s.method != methods[m]) continue;
      columns[0].push_back(static_cast<double>(s.stems_in_map));
      columns[1].push_back(s.time_p50_ms);
      columns[2].push_back(s.time_p95_ms);
      columns[3].push_back(s.build_ms);
    }
    const std::string block = figure.data(methods[m] + ": stems, p50, p95, map (ms)", columns);
    const std::string style = " lw 1.8 lc " + series_colour(m);
    elements.push_back(block + " using 1:2:2:3 with yerrorlines pt " + series_point(m) + style +
                       " title " + gnuplot_text(methods[m] + ", a query"));
    elements.push_back(block + " using 1:4 with lines dt 2" + style + " title " +
                       gnuplot_text(methods[m] + ", graph or index of the map"));
  }
  figure.plot(elements);
  return figure.draw("Time against the size of the map",
                     "Both axes are logarithmic: a slope of 1 is proportional.");
}

ReportFigure draw_sighting_exhibit(const std::filesystem::path& folder,
                                   const SightingExhibit& exhibit) {
  Figure figure(folder, exhibit.name, 760, 800);
  figure.title(exhibit.title, exhibit.verdict);
  const Eigen::Vector2d& at_m = exhibit.T_map_sensor.translation_m;
  const double reach_m = 1.35 * exhibit.range_m;
  const auto range = [&](const char* axis, double middle) {
    return fmt::format("set {}range [{:.2f}:{:.2f}]", axis, middle - reach_m, middle + reach_m);
  };
  figure << range("x", at_m.x()) << range("y", at_m.y()) << "set size ratio -1"
         << "set xlabel 'x in the map (m)'\nset ylabel 'y in the map (m)'";
  figure.key_below(130);
  const Eigen::Vector2d ahead_m = exhibit.T_map_sensor * Eigen::Vector2d(6.0, 0.0);
  figure << fmt::format("set arrow from {:.3f},{:.3f} to {:.3f},{:.3f} lw 3 lc {}", at_m.x(),
                        at_m.y(), ahead_m.x(), ahead_m.y(), kBlack);
  Texts elements = {figure.data("map: x y", exhibit.map_m) + " with points pt 6 ps 1.1 lw 1.4 lc " +
                        kGrey + " title 'stems of the map'",
                    figure.data("list, trees of the map: x y", exhibit.list_in_map_m) +
                        " with points pt 7 ps 0.55 lc " + kBlue +
                        " title 'listed: a tree of the map'"};
  if (!exhibit.felled_or_false_in_map_m.empty()) {
    elements.push_back(figure.data("list, others: x y", exhibit.felled_or_false_in_map_m) +
                       " with points pt 2 ps 0.8 lw 1.6 lc " + kRed +
                       " title 'listed: no tree of the map'");
  }
  elements.push_back(figure.data("sensor: x y", std::vector<Eigen::Vector2d>{at_m}) +
                     " with points pt 5 ps 1.2 lc " + kBlack + " title 'sensor, as answered'");
  figure.plot(elements);
  return figure.draw(exhibit.title, exhibit.caption);
}

}  // namespace honka::eval
