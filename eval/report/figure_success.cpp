#include "eval/report/figure_success.h"

#include <algorithm>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// The place of a number of frames on the axis: 1, 3, 5, 10 stand at equal distances.
double place_of(std::int64_t frames, const std::vector<std::int64_t>& all) {
  return static_cast<double>(std::find(all.begin(), all.end(), frames) - all.begin());
}

std::vector<std::int64_t> all_frames(const SuccessFigure& input) {
  std::vector<std::int64_t> all;
  const auto add = [&](const std::vector<SuccessPoint>& points) {
    for (const SuccessPoint& point : points) all.push_back(point.frames);
  };
  for (const SuccessSeries& series : input.series) add(series.points);
  add(input.paper);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::vector<double>> columns(const std::vector<SuccessPoint>& points,
                                         const std::vector<std::int64_t>& all, double shift) {
  std::vector<std::vector<double>> result(4);
  for (const SuccessPoint& point : points) {
    result[0].push_back(place_of(point.frames, all) + shift);
    result[1].push_back(100.0 * point.rate);
    result[2].push_back(100.0 * point.low);
    result[3].push_back(100.0 * point.high);
  }
  return result;
}

}  // namespace

ReportFigure draw_success(const std::filesystem::path& folder, const SuccessFigure& input) {
  const auto all = all_frames(input);
  Figure figure(folder, "success", 800, 540);
  figure.title("Success rate by number of key frames", input.protocol);
  std::string tics;
  for (std::size_t i = 0; i < all.size(); ++i) {
    tics += (i > 0 ? ", " : "") + gnuplot_text(std::to_string(all[i])) + " " + std::to_string(i);
  }
  figure << "set xtics (" + tics + ")"
         << "set xrange [-0.5:" + number(static_cast<double>(all.size()) - 0.5) + "]"
         << "set yrange [0:104]"
         << "set xlabel 'key frames in a window'"
         << "set ylabel 'success rate (%)'"
         << "set key bottom right";
  std::vector<std::string> elements;
  const double step = 0.12;
  const double first = -0.5 * step * static_cast<double>(input.series.size());
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    const std::string block =
        figure.data(input.series[i].label + ": place, rate, low, high (%)",
                    columns(input.series[i].points, all, first + step * static_cast<double>(i)));
    elements.push_back(block + " using 1:2 with lines lw 0.8 lc " + series_colour(i) + " notitle");
    elements.push_back(block + " using 1:2:3:4 with yerrorbars lw 2 pt " + series_point(i) +
                       " ps 0.9 lc " + series_colour(i) + " title " +
                       gnuplot_text(input.series[i].label + ", 95 % interval"));
  }
  const std::string paper = figure.data(
      "paper: place, rate (%)",
      columns(input.paper, all, first + step * static_cast<double>(input.series.size())));
  elements.push_back(paper + " using 1:2 with points pt 2 ps 1.3 lw 2.5 lc " + kPink +
                     " title 'the paper, Table 1'");
  figure.plot(elements);
  return figure.draw("Success rate",
                     "Share of windows localized, with 95 % Wilson intervals, beside the figures "
                     "of the paper's Table 1, which gives no interval.");
}

ReportFigure draw_speed(const std::filesystem::path& folder, const SpeedFigure& input) {
  const auto n = input.rows.size();
  Figure figure(folder, "speed", 900, static_cast<int>(200 + 34 * n));
  figure.title("Highest speed that each row keeps up with", input.protocol);
  std::vector<double> places, speeds;
  std::string tics;
  double top = 2.0, bottom = 0.4;
  for (std::size_t i = 0; i < n; ++i) {
    places.push_back(static_cast<double>(n - i));
    speeds.push_back(input.rows[i].speed_m_per_s);
    top = std::max(top, speeds.back());
    if (speeds.back() > 0.0) bottom = std::min(bottom, speeds.back());
    tics += (i > 0 ? ", " : "") + gnuplot_text(input.rows[i].label) + " " + std::to_string(n - i);
    figure << "set label " + gnuplot_text(fixed(speeds.back(), speeds.back() < 10.0 ? 2 : 1)) +
                  " at " + number(speeds.back()) + "," + number(places.back()) +
                  " left offset 0.5,0 front";
  }
  const std::string block = figure.data("speed m/s, place", {speeds, places});
  const std::string limits = "0.4:" + number(static_cast<double>(n) + 0.6);
  figure << "set logscale x"
         << "set ytics (" + tics + ")"
         << "set yrange [" + limits + "]"
         << "set xrange [" + number(0.5 * bottom) + ":" + number(2.5 * top) + "]"
         << "set xlabel 'speed (m/s), logarithmic'"
         << "set arrow from 0.5,graph 0 to 0.5,graph 1 nohead lw 2 dt 2 lc " + std::string(kPink)
         << "set arrow from 1,graph 0 to 1,graph 1 nohead lw 2 dt 4 lc " + std::string(kRed)
         << "set boxwidth 0.5"
         << "set style fill solid 0.75";
  figure.key_below(110);
  figure.plot({block + " using (0.5*(" + number(0.5 * bottom) + "+$1)):2:(" + number(0.5 * bottom) +
                   "):1:($2-0.3):($2+0.3) with boxxyerror lc " + kBlue + " title 'ours'",
               "NaN with lines lw 2 dt 2 lc " + std::string(kPink) + " title 'the paper: 0.5 m/s'",
               "NaN with lines lw 2 dt 4 lc " + std::string(kRed) + " title 'the paper: 1 m/s'"});
  return figure.draw("Highest speed",
                     "Path between two localizations divided by the time that one takes on this "
                     "machine, beside the 0.5 and 1 m/s of the paper.");
}

}  // namespace honka::eval
