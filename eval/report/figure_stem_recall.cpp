#include "eval/report/figure_stem_recall.h"

#include "eval/report/gnuplot.h"

namespace honka::eval {

ReportFigure draw_stem_recall(const std::filesystem::path& folder, const StemRecallFigure& input) {
  Figure figure(folder, "stem_recall", 1000, 460);
  std::vector<std::string> recall, precision;
  for (std::size_t i = 0; i < input.series.size(); ++i) {
    const StemRecallSeries& series = input.series[i];
    std::vector<std::vector<double>> columns(3);
    for (const RangeBin& bin : series.bins) {
      columns[0].push_back(0.5 * (bin.low_m + bin.high_m));
      columns[1].push_back(100.0 * bin.recall);
      columns[2].push_back(100.0 * bin.precision);
    }
    const std::string block =
        figure.data(series.label + ": range m, recall %, precision %", columns);
    const std::string style = " with linespoints lw 1.8 pt " + series_point(i) + " ps 0.8 lc " +
                              series_colour(i) + " title " + gnuplot_text(series.label);
    recall.push_back(block + " using 1:2" + style);
    precision.push_back(block + " using 1:3" + style);
  }
  figure << "set multiplot layout 1,2 title " +
                gnuplot_text("Stem detection by range from the sensor: " + input.protocol) +
                " font ',14'"
         << "set yrange [0:104]"
         << "set xrange [0:*]"
         << "set xlabel 'range (m)'"
         << "set key bottom left";
  figure << "set ylabel 'recall (% of the stems that stand there)'";
  figure.plot(recall);
  figure << "set ylabel 'precision (% of what was found)'";
  figure.plot(precision);
  figure << "unset multiplot";
  return figure.draw("Stem detection by range",
                     "Recall: share of the true stems of a ring that were found. Precision: share "
                     "of what was found there that is a stem. Points stand in the middle of their "
                     "ring.");
}

}  // namespace honka::eval
