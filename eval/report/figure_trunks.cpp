#include "eval/report/figure_trunks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The highest count or paper's mean of all panels: they share their scale.
double top_of(const WindowCountsFigure& input) {
  double top = 1.0;
  for (const WindowCounts& series : input.series) {
    for (const double count : series.counts) top = std::max(top, count);
    top = std::max(top, series.paper_mean.value_or(0.0));
  }
  return top;
}

void draw_panel(Figure& figure, const WindowCounts& series, std::size_t i) {
  std::vector<double> windows(series.counts.size());
  std::iota(windows.begin(), windows.end(), 1.0);
  const std::string block =
      figure.data(frames_label(series.frames) + ": window, count", {windows, series.counts});
  const double mean = mean_of(series.counts);
  std::string label = frames_label(series.frames) + ": mean " + fixed(mean, 2);
  if (series.paper_mean) label += ", paper " + fixed(*series.paper_mean, 2);
  figure << "set label 1 " + gnuplot_text(label) + " at graph 0.0,1.07 front font ',12'";
  std::vector<std::string> elements = {
      block + " with impulses lw 1 lc " + series_colour(i) + " notitle",
      block + " with points pt " + series_point(i) + " ps 0.35 lc " + series_colour(i) +
          " notitle"};
  if (std::isfinite(mean)) {
    elements.push_back(number(mean) + " with lines lw 1.6 lc " + kBlack + " title 'our mean'");
  }
  if (series.paper_mean) {
    elements.push_back(number(*series.paper_mean) + " with lines lw 2 dt 2 lc " + kPink +
                       " title 'the paper’s mean'");
  }
  figure.plot(elements);
}

ReportFigure draw_counts(Figure& figure, const WindowCountsFigure& input, const std::string& what,
                         const std::string& report_title, const std::string& caption) {
  std::size_t longest = 1;
  for (const WindowCounts& series : input.series) longest = std::max(longest, series.counts.size());
  const auto panels = static_cast<double>(std::max<std::size_t>(1, input.series.size()));
  figure << "set multiplot"
         << "set lmargin at screen 0.08"
         << "set rmargin at screen 0.98"
         << "set xrange [0:" + number(static_cast<double>(longest) + 1.0) + "]"
         << "set yrange [0:" + number(1.1 * top_of(input)) + "]"
         << "set ylabel " + gnuplot_text(what) << "set format x ''";
  figure.title(what + " in each window, by number of key frames", input.protocol);
  const double pitch = 0.83 / panels;
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    const double top = 0.885 - pitch * static_cast<double>(i);
    figure << "set tmargin at screen " + number(top)
           << "set bmargin at screen " + number(top - pitch + 0.045);
    figure << (i == 0 ? "set key at graph 1,1.16 right horizontal" : "unset key");
    if (i + 1 == input.series.size()) {
      figure << "set format x '%g'"
             << "set xlabel 'window, along the path'";
    }
    draw_panel(figure, input.series[i], i);
    figure << "unset title";
  }
  figure << "unset multiplot";
  return figure.draw(report_title, caption);
}

}  // namespace

ReportFigure draw_trunks(const std::filesystem::path& folder, const WindowCountsFigure& input) {
  Figure figure(folder, "trunks", 1000, 760);
  return draw_counts(figure, input, "Trunks", "Trunks in each window (the paper's Figure 8)",
                     "Stems that Algorithm 1 found in each window, for windows of 1, 3, 5 and 10 "
                     "key frames. Solid: our mean; dashed: the mean of the paper's Table 1.");
}

ReportFigure draw_matches(const std::filesystem::path& folder, const WindowCountsFigure& input) {
  Figure figure(folder, "matches", 1000, 760);
  return draw_counts(figure, input, "Matching triangles",
                     "Matching triangles in each window (the paper's Figure 9)",
                     "Local stars that found a partner in the map, for windows of 1, 3, 5 and 10 "
                     "key frames. Solid: our mean; dashed: the mean of the paper's Table 1.");
}

}  // namespace honka::eval
