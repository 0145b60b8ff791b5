#include "eval/report/figure_map_cloud.h"

#include <algorithm>

#include "eval/report/gnuplot.h"
#include "eval/report/plot_points.h"

namespace honka::eval {
namespace {

std::string range(const char* axis, std::pair<double, double> limits, double margin) {
  return std::string("set ") + axis + "range [" + number(limits.first - margin) + ":" +
         number(limits.second + margin) + "]";
}

std::vector<double> coordinate(const std::vector<Eigen::Vector3d>& points, int axis) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(point[axis]);
  return values;
}

/// The strip at the foot of the picture: x against z.
void draw_side_view(Figure& figure, const std::string& cloud, std::pair<double, double> z,
                    double strip, int height) {
  figure << "unset title"
         << "unset key"
         << "unset colorbox"
         << "set format x '%g'"
         << "set tmargin at screen " + number(strip + 50.0 / height)
         << "set bmargin at screen " + number(64.0 / height) << "set xlabel 'x (m)'"
         << "set ylabel 'z (m)'" << range("y", z, 1.0)
         << "set label 1 'from the side' at graph 0.01,0.9 front";
  figure.plot({cloud + " using 1:3:3 with points pt 7 ps 0.15 lc palette notitle"});
}

}  // namespace

ReportFigure draw_map_cloud(const std::filesystem::path& folder, const MapCloudFigure& input) {
  const auto points = thinned(input.cloud, 60000);
  const auto x = quantile_range(coordinate(points, 0), 0.002, 0.998);
  const auto y = quantile_range(coordinate(points, 1), 0.002, 0.998);
  const auto z = quantile_range(coordinate(points, 2), 0.002, 0.998);
  // Both views share the scale along x: the picture is as tall as the stand is deep.
  const double shape = std::clamp((y.second - y.first) / std::max(1.0, x.second - x.first), .2, 2.);
  const int height = static_cast<int>(336.0 + 780.0 * shape);
  const double strip = 186.0 / height, top = 1.0 - 64.0 / height;
  Figure figure(folder, "map_cloud", 1000, height, Figure::Format::kPng);
  const std::string cloud = figure.data("cloud: x y z, map frame, m", columns_of(points));
  const std::string path = figure.data("path of the sensor: x y", input.path);
  const std::string stems = figure.data("stems found in the cloud: x y", input.stems);
  figure << kHeightPalette << range("cb", z, 0.0) << "set cblabel 'z (m)'"
         << "set tics out" << range("x", x, 2.0) << "set lmargin at screen 0.09"
         << "set rmargin at screen 0.87"
         << "set multiplot";
  figure.title("Point-cloud map, from above", input.protocol);
  figure << "set tmargin at screen " + number(top)
         << "set bmargin at screen " + number(strip + 110.0 / height) << range("y", y, 2.0)
         << "set ylabel 'y (m)'"
         << "set format x ''"
         << "set key at screen 0.87,screen " + number(strip + 96.0 / height) +
                " right top horizontal";
  figure.plot(
      {cloud + " using 1:2:3 with dots lc palette notitle",
       stems + " using 1:2 with points pt 6 ps 0.7 lw 1.2 lc " + kRed + " title 'stem found'",
       path + " using 1:2 with lines lw 2.5 lc " + kBlack + " title 'path of the sensor'"});
  draw_side_view(figure, cloud, z, strip, height);
  figure << "unset multiplot";
  return figure.draw("Point-cloud map (the paper's Figure 1c)",
                     "The map that local scans are matched with, from above and from the side, "
                     "coloured by height; " +
                         std::to_string(points.size()) + " of " +
                         std::to_string(input.cloud.size()) + " points, " +
                         std::to_string(input.stems.size()) + " stems found.");
}

}  // namespace honka::eval
