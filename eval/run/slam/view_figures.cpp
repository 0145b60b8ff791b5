#include "eval/run/slam/view_figures.h"

#include <fmt/format.h>

#include "eval/report/gnuplot.h"

namespace honka::eval {

ReportFigure draw_single_view(const std::filesystem::path& folder, const SparseFrame& frame) {
  std::vector<Eigen::Vector2d> stems;
  for (const Eigen::Vector3d& p : frame.points_m) stems.emplace_back(p.head<2>());
  Figure figure(folder, "fig1_view", 700, 700);
  figure.title("A single view", fmt::format("key frame {}: {} stems", frame.number, stems.size()));
  figure << "set size ratio -1"
         << "set xrange [-40:40]\nset yrange [-40:40]"
         << "set xtics 10\nset ytics 10"
         << "set xlabel 'x ahead (m)'"
         << "set ylabel 'y left (m)'"
         << fmt::format("set arrow from 0,0 to 5,0 lw 2.5 lc {} front", kRed);
  figure.key_below(115);
  figure.plot({figure.data("stems: x y", stems) + " with points pt 7 ps 0.5 lc " + kBlue +
                   " title 'stems found by the edge'",
               figure.data("scanner: x y", std::vector<Eigen::Vector2d>{{0.0, 0.0}}) +
                   " with points pt 9 ps 1.2 lc " + kRed + " title 'scanner'"});
  return figure.draw("Figure 1: a single view",
                     "Each point is a stem, from above; points are in space. The frame is the one "
                     "whose number of stems is nearest to the mean.");
}

ReportFigure draw_range_distances(const std::filesystem::path& folder,
                                  const std::vector<ViewRangeBin>& bins, const ViewMeans& means) {
  std::vector<Eigen::Vector2d> all, inner;
  for (const ViewRangeBin& bin : bins) {
    all.emplace_back(bin.range_m, bin.all.mean());
    inner.emplace_back(bin.range_m, bin.inner.mean());
  }
  Figure figure(folder, "fig1_distances", 820, 540);
  figure.title("Distance to natural neighbours by range", "mean over the stems of all key frames");
  figure << "set xlabel 'range from the scanner (m)'"
         << "set ylabel 'mean distance to natural neighbours (m)'"
         << "set xrange [0:40]\nset yrange [0:*]";
  figure.key_below(135);
  figure.plot(
      {figure.data("all: range distance", all) + " with linespoints lw 1.6 pt 7 ps 0.6 lc " + kRed +
           " title 'all stems'",
       figure.data("inner: range distance", inner) + " with linespoints lw 1.6 pt 5 ps 0.6 lc " +
           kBlue + " title 'rim left out'",
       number(means.inner_m) + " with lines dt 2 lw 1.6 lc " + kBlue +
           fmt::format(" title 'L0 = {:.2f} m, rim left out'", means.inner_m),
       number(3.5) + " with lines dt 2 lw 1.6 lc " + kGrey + " title 'L0 = 3.5 m, the paper'"});
  return figure.draw("Figure 1: neighbours' distance by range",
                     "Close to the scanner is the road, without stems. At the rim nothing is seen "
                     "beyond, and all neighbours lie to one side; with the rim left out, the far "
                     "stems that remain are those that others surround.");
}

}  // namespace honka::eval
