#include "eval/report/figure_stand.h"

#include <algorithm>

#include "eval/report/gnuplot.h"

namespace honka::eval {

ReportFigure draw_stand(const std::filesystem::path& folder, const StandFigure& input) {
  Eigen::Array2d low(0.0, 0.0), high(1.0, 1.0);
  if (!input.stems.empty()) low = high = input.stems.front().position_m.array();
  std::vector<std::vector<double>> stems(3);
  for (const Stem& stem : input.stems) {
    low = low.min(stem.position_m.array());
    high = high.max(stem.position_m.array());
    stems[0].push_back(stem.position_m.x());
    stems[1].push_back(stem.position_m.y());
    stems[2].push_back(3.0 * stem.dbh_m.value_or(0.25));  // six times as thick as in the stand
  }
  const double shape =
      std::clamp((high.y() - low.y()) / std::max(1.0, high.x() - low.x()), .3, 1.8);
  Figure figure(folder, "stand", 900, static_cast<int>(190.0 + 760.0 * shape),
                Figure::Format::kPng);
  figure.title("The stand: " + std::to_string(input.stems.size()) + " trees", input.protocol);
  const std::string trees = figure.data("trees: x y, 3 × DBH (m)", stems);
  const std::string roads = figure.lines("strip roads: x y", input.roads);
  const std::string path = figure.data("path: x y", input.work_path);
  const std::string starts = figure.data("window starts: x y", input.window_starts);
  figure << "set size ratio -1"
         << "set xlabel 'x, east (m)'"
         << "set ylabel 'y, north (m)'"
         << "set xrange [" + number(low.x() - 3) + ":" + number(high.x() + 3) + "]"
         << "set yrange [" + number(low.y() - 3) + ":" + number(high.y() + 3) + "]";
  figure.key_below(115);
  figure.plot({roads + " with lines lw 5 lc '#F3D9A4' title 'road of the prior run'",
               trees + " with circles fs solid 0.9 noborder lc " + kGreen + " notitle",
               "NaN with points pt 7 ps 1 lc " + std::string(kGreen) + " title 'tree, DBH × 6'",
               path + " with lines lw 2 lc " + kBlue + " title 'localized drive'",
               starts + " with points pt 7 ps 0.45 lc " + kRed + " title 'start of a window'"});
  return figure.draw("The stand",
                     "Trees drawn six times as thick as they are, the roads of the run that "
                     "made the map, the drive that is localized in it, and where its windows "
                     "begin.");
}

}  // namespace honka::eval
