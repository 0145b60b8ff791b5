#include "eval/run/slam/selection_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// Points of each kind that a panel shows.
constexpr std::size_t kShownPairs = 4000;

std::vector<Eigen::Vector2d> overlap_and_error(const std::vector<FramePair>& pairs) {
  std::vector<Eigen::Vector2d> points;
  for (const FramePair& pair : pairs) {
    if (points.size() == kShownPairs) break;
    points.emplace_back(pair.overlap, pair.error_m);
  }
  return points;
}

std::vector<Eigen::Vector2d> frames_of(const std::vector<FramePair>& pairs) {
  std::vector<Eigen::Vector2d> points;
  for (const FramePair& pair : pairs) points.emplace_back(pair.j, pair.i);
  return points;
}

std::string test_text(const std::string& test) {
  return test == "icp" ? "after an ICP attempt" : "as they lie in the chain";
}

void draw_error_panel(Figure& figure, const SelectionCase& c) {
  const std::vector<Eigen::Vector2d> line = {
      {c.overlap_limit, c.error_at_no_overlap_m + c.error_slope_m * c.overlap_limit},
      {1.0, c.error_at_no_overlap_m + c.error_slope_m}};
  std::vector<std::string> elements;
  if (!c.found.inferior.empty()) {
    elements.push_back(
        figure.data(c.test + ", inferior: λ e", overlap_and_error(c.found.inferior)) +
        " with points pt 7 ps 0.25 lc " + kGrey + " title 'inferior'");
  }
  if (!c.found.promising.empty()) {
    elements.push_back(
        figure.data(c.test + ", promising: λ e", overlap_and_error(c.found.promising)) +
        " with points pt 7 ps 0.25 lc " + kBlack + " title 'promising'");
  }
  elements.push_back(figure.data("Eq. 27: λ e", line) + " with lines lw 2.5 lc " + kRed +
                     " title 'Eq. 27'");
  figure << "set title " +
                gnuplot_text(fmt::format("{}: {} promising of {} judged", test_text(c.test),
                                         c.found.promising.size(), c.judged()));
  figure.plot(elements);
}

}  // namespace

ReportFigure draw_pair_errors(const std::filesystem::path& folder,
                              const std::vector<SelectionCase>& cases) {
  Figure figure(folder, "fig9_overlap_error", 1100, 520, Figure::Format::kPng);
  figure << "set multiplot layout 1," + std::to_string(cases.size())
         << "set xlabel 'view cone overlap λ'"
         << "set ylabel 'match error e (m)'"
         << "set xrange [0:1]"
         << "set yrange [0:2.5]"
         << "set key top right";
  for (const SelectionCase& c : cases) draw_error_panel(figure, c);
  figure << "unset multiplot";
  return figure.draw(
      "Figure 9: match error over overlap",
      "Random pairs of the first trial whose view cones overlap enough, and the line of Eq. 27: "
      "below it a pair is promising. At most 4,000 points of each kind; errors above 2.5 m are not "
      "shown.");
}

ReportFigure draw_pair_choice(const std::filesystem::path& folder, const SelectionCase& c) {
  std::vector<FramePair> chosen;
  for (const std::size_t k : c.choice.chosen) chosen.push_back(c.found.promising[k]);
  const double n = std::max(2.0, static_cast<double>(c.frames));
  Figure figure(folder, "fig10_pair_choice", 900, 820, Figure::Format::kPng);
  figure.title(
      "Promising pairs and the chosen ones",
      fmt::format("{} pairs in I2, {} chosen near the {} points of a grid of {:.0f} frames",
                  c.found.promising.size(), chosen.size(), c.choice.grid_points, c.choice.spacing));
  figure << "set xlabel 'frame j'"
         << "set ylabel 'frame i'"
         << "set xrange [0:" + number(n) + "]"
         << "set yrange [0:" + number(n) + "]"
         << "set key bottom right";
  std::vector<std::string> elements;
  elements.push_back(
      figure.data("the chain: j i", std::vector<Eigen::Vector2d>{{0.0, 1.0}, {n - 1.0, n}}) +
      " with lines lw 1 lc " + kGrey + " title 'the chain, i = j + 1'");
  if (!c.found.promising.empty()) {
    elements.push_back(figure.data("I2: j i", frames_of(c.found.promising)) +
                       " with points pt 7 ps 0.3 lc " + kBlack + " title 'I2'");
    elements.push_back(figure.data("I: j i", frames_of(chosen)) +
                       " with points pt 6 ps 1.5 lw 2 lc " + kRed + " title 'I'");
  }
  figure.plot(elements);
  return figure.draw(
      "Figure 10: the selection of extra matches",
      "Each dot ties a later frame i to an earlier frame j. Black: I2, the promising "
      "pairs of the first trial. Red: I, the pairs that are corrected by.");
}

}  // namespace honka::eval
