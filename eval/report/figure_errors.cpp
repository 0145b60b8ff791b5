#include "eval/report/figure_errors.h"

#include <algorithm>
#include <cmath>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// Steps of the empirical distribution: error, percent of windows at or below it.
std::vector<Eigen::Vector2d> distribution(std::vector<double> errors) {
  std::erase_if(errors, [](double error) { return !std::isfinite(error); });
  std::sort(errors.begin(), errors.end());
  std::vector<Eigen::Vector2d> steps;
  if (!errors.empty()) steps.emplace_back(0.0, 0.0);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    steps.emplace_back(errors[i],
                       100.0 * static_cast<double>(i + 1) / static_cast<double>(errors.size()));
  }
  return steps;
}

}  // namespace

ReportFigure draw_errors(const std::filesystem::path& folder, const ErrorsFigure& input) {
  Figure figure(folder, "errors", 1000, 460);
  std::vector<std::string> truth, odometry;
  double largest = 0.55;
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    const ErrorSeries& series = input.series[i];
    const std::string style = " with steps lw 2 lc " + series_colour(i) + " title ";
    const std::string label = frames_label(series.frames) + ", n = ";
    const auto to_truth = distribution(series.to_truth_m);
    const auto to_odometry = distribution(series.to_odometry_m);
    for (const auto* steps : {&to_truth, &to_odometry}) {
      if (!steps->empty()) largest = std::max(largest, steps->back().x());
    }
    const auto n = [](const auto& steps) {
      return std::to_string(steps.empty() ? 0 : steps.size() - 1);
    };
    truth.push_back(figure.data(label + "to truth: m, %", to_truth) + style +
                    gnuplot_text(label + n(to_truth)));
    odometry.push_back(figure.data(label + "to odometry: m, %", to_odometry) + style +
                       gnuplot_text(label + n(to_odometry)));
  }
  figure << "set multiplot layout 1,2 title " +
                gnuplot_text("Translation error: " + input.protocol) + " font ',14'"
         << "set xrange [0:" + number(std::min(1.05 * largest, 1.5)) + "]"
         << "set yrange [0:104]"
         << "set key bottom right"
         << "set ylabel 'windows at or below (%)'"
         << "set arrow from 0.5,graph 0 to 0.5,graph 1 nohead lw 1.5 dt 2 lc " + std::string(kGrey)
         << "set xlabel 'error to truth (m)'";
  figure.plot(truth);
  figure << "set xlabel 'error to the odometry track (m)'";
  figure.plot(odometry);
  figure << "unset multiplot";
  return figure.draw("Translation error",
                     "Share of the accepted windows with at most this error: to the truth of the "
                     "simulator, and to the odometry track, which is how the paper measures. "
                     "Dashed: the 0.5 m that a success may have.");
}

}  // namespace honka::eval
