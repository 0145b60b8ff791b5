#include "eval/report/figure_segmentation.h"

#include <algorithm>
#include <cmath>

#include "eval/report/gnuplot.h"
#include "eval/report/plot_points.h"

namespace honka::eval {
namespace {

using Cloud = std::vector<Eigen::Vector3d>;

Cloud slice(const Cloud& points, double half_width_m) {
  Cloud inside;
  for (const auto& point : points) {
    if (std::abs(point.y()) <= half_width_m) inside.push_back(point);
  }
  return thinned(inside, 40000);
}

std::pair<double, double> limits(const Cloud& points, int axis) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(point[axis]);
  return quantile_range(values, 0.003, 0.997);
}

/// The place of panel 0, 1 or 2 from the top.
void place_panel(Figure& figure, int panel) {
  figure << "set tmargin at screen " + number(0.90 - 0.29 * panel)
         << "set bmargin at screen " + number(0.68 - 0.29 * panel);
  if (panel == 2) figure << "set xlabel 'x, ahead of the sensor (m)'";
}

/// What the three panels share: ranges, names of the axes, the scale of heights.
void set_style(Figure& figure, std::pair<double, double> x, std::pair<double, double> z) {
  figure << "set multiplot"
         << "set lmargin at screen 0.08"
         << "set rmargin at screen 0.87"
         << "set xrange [" + number(x.first - 1) + ":" + number(x.second + 1) + "]"
         << "set yrange [" + number(z.first - 0.5) + ":" + number(z.second + 0.5) + "]"
         << "set cbrange [" + number(z.first) + ":" + number(z.second) + "]" << kHeightPalette
         << "set ylabel 'z (m)'"
         << "set cblabel 'z (m)'"
         << "set key at graph 1,1.16 right horizontal";
}

}  // namespace

ReportFigure draw_segmentation(const std::filesystem::path& folder,
                               const SegmentationFigure& input) {
  const Cloud original = slice(input.original, input.slice_half_width_m);
  const auto x = limits(original, 0), z = limits(original, 2);
  Figure figure(folder, "segmentation", 1000, 900, Figure::Format::kPng);
  const std::string all = figure.data("(a) original: x y z", columns_of(original));
  const std::string removed =
      figure.data("(b) removed: x y z", columns_of(slice(input.removed, input.slice_half_width_m)));
  const std::string kept =
      figure.data("(b) kept: x y z", columns_of(slice(input.kept, input.slice_half_width_m)));
  const std::string clusters = figure.data(
      "(c) clusters: x y z", columns_of(slice(input.clusters, input.slice_half_width_m)));
  set_style(figure, x, z);
  figure.title("Trunk segmentation in three stages, seen from the side", input.protocol);
  place_panel(figure, 0);
  figure << "set label 1 '(a) original cloud' at graph 0.01,1.06 front";
  figure.plot({all + " using 1:3:3 with points pt 7 ps 0.25 lc palette notitle"});
  figure << "unset title"
         << "unset colorbox"
         << "set label 1 '(b) ground and branches removed' at graph 0.01,1.06 front";
  place_panel(figure, 1);
  figure.plot({removed + " using 1:3 with points pt 7 ps 0.25 lc " + kRed + " notitle",
               kept + " using 1:3 with points pt 7 ps 0.3 lc " + kBlue + " notitle",
               "NaN with points pt 7 ps 1 lc " + std::string(kRed) + " title 'removed'",
               "NaN with points pt 7 ps 1 lc " + std::string(kBlue) + " title 'trunk candidate'"});
  figure << "set label 1 '(c) after clustering' at graph 0.01,1.06 front";
  place_panel(figure, 2);
  figure.plot({clusters + " using 1:3 with points pt 7 ps 0.3 lc " + kGreen + " notitle",
               "NaN with points pt 7 ps 1 lc " + std::string(kGreen) + " title 'stem'"});
  figure << "unset multiplot";
  return figure.draw("Trunk segmentation (the paper's Figure 5)",
                     "Algorithm 1 on one window, a slice of " +
                         fixed(2.0 * input.slice_half_width_m, 0) +
                         " m along the sensor's axis: (a) the cloud coloured by height, (b) trunk "
                         "candidates blue and what is removed vermilion, (c) the final stems.");
}

}  // namespace honka::eval
