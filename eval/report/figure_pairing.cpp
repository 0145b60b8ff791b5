#include <algorithm>
#include <cmath>

#include "eval/report/figure_matched_stars.h"
#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

StarVertices moved(const StarVertices& star, const Eigen::Vector2d& by) {
  StarVertices result = star;
  for (auto& vertex : result) vertex += by;
  return result;
}

Eigen::Vector2d centroid(const StarVertices& star) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& vertex : star) sum += vertex / 6.0;
  return sum;
}

double radius(const StarVertices& star) {
  double largest = 1.0;
  for (const auto& v : star) largest = std::max(largest, (v - centroid(star)).norm());
  return largest;
}

/// Letters beside the vertices, pushed away from the star's middle.
void add_letters(Figure& figure, const StarVertices& star, const char* letters, double offset) {
  for (std::size_t i = 0; i < star.size(); ++i) {
    const Eigen::Vector2d out = star[i] - centroid(star);
    const Eigen::Vector2d at = star[i] + offset * out / std::max(1e-9, out.norm());
    figure << "set label " + gnuplot_text(std::string(1, letters[i])) + " at " + number(at.x()) +
                  "," + number(at.y()) + " center front font ',15'";
  }
}

void add_elements(Figure& figure, std::vector<std::string>& elements, const StarVertices& star,
                  const std::string& name, const std::string& colour) {
  const auto outlines = star_outlines(star);
  const std::string centre = figure.lines(name + " triangle: x y", {outlines[0]});
  const std::string around =
      figure.lines(name + " neighbours: x y", {outlines.begin() + 1, outlines.end()});
  elements.push_back(around + " with filledcurves closed fs transparent solid 0.15 lc " + colour +
                     " notitle");
  elements.push_back(centre + " with filledcurves closed fs transparent solid 0.5 lc " + colour +
                     " title " + gnuplot_text(name));
  elements.push_back(around + " with lines lw 1.5 lc " + colour + " notitle");
  elements.push_back(around + " with points pt 7 ps 0.9 lc " + colour + " notitle");
}

}  // namespace

ReportFigure draw_pairing(const std::filesystem::path& folder, const PairingFigure& input) {
  const double size = std::max(radius(input.local_star), radius(input.map_star));
  const double shift = 2.5 * size;
  const StarVertices left = moved(input.local_star, -centroid(input.local_star));
  const StarVertices right =
      moved(input.map_star, Eigen::Vector2d(shift, 0.0) - centroid(input.map_star));
  Figure figure(folder, "pairing", 1000, 520);
  figure.title("One matched pair of stars", input.protocol);
  figure << "set size ratio -1"
         << "unset border"
         << "unset tics"
         << "unset grid"
         << "set key bottom center horizontal outside"
         << "set xrange [" + number(-1.25 * size) + ":" + number(shift + 1.25 * size) + "]"
         << "set yrange [" + number(-1.35 * size) + ":" + number(1.25 * size) + "]";
  add_letters(figure, left, "ABCDEF", 0.11 * size);
  add_letters(figure, right, "MHNQRT", 0.11 * size);
  std::vector<std::vector<Eigen::Vector2d>> pairs;
  for (std::size_t i = 0; i < left.size(); ++i) pairs.push_back({left[i], right[i]});
  std::vector<std::string> elements = {figure.lines("paired vertices: x y", pairs) +
                                       " with lines dt 2 lw 1 lc " + kGrey +
                                       " title 'paired vertices'"};
  add_elements(figure, elements, left, "local triangle", kBlue);
  add_elements(figure, elements, right, "map triangle", kGreen);
  const double bar = size > 12.0 ? 10.0 : 2.0;
  elements.push_back(figure.lines("scale bar: x y", {{{-1.2 * size, -1.25 * size},
                                                      {-1.2 * size + bar, -1.25 * size}}}) +
                     " with lines lw 3 lc " + kBlack + " notitle");
  figure << "set label " + gnuplot_text(number(bar) + " m") + " at " +
                number(-1.2 * size + bar / 2.0) + "," + number(-1.17 * size) + " center front";
  figure.plot(elements);
  return figure.draw("Pairing of vertices (the paper's Figure 7)",
                     "A local triangle A, B, C and its map triangle M, H, N, each turned as it "
                     "lies in its own frame, with the far vertices of the neighbours D, E, F and "
                     "Q, R, T; dashed lines join the vertices that are paired.");
}

}  // namespace honka::eval
