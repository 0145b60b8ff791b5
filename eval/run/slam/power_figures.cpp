#include "eval/run/slam/power_figures.h"

#include <array>
#include <limits>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// Origin and direction of one axis of each frame, for "with vectors".
std::vector<std::vector<double>> axis_columns(const std::vector<Pose3>& frames, int axis) {
  std::vector<std::vector<double>> columns(6);
  for (const Pose3& frame : frames) {
    for (int k = 0; k < 3; ++k) {
      columns[static_cast<std::size_t>(k)].push_back(frame.translation()[k]);
      columns[static_cast<std::size_t>(k + 3)].push_back(frame.linear()(k, axis));
    }
  }
  return columns;
}

/// For an axis of logarithms a zero is a gap.
std::vector<Eigen::Vector2d> without_zeros(std::vector<Eigen::Vector2d> curve) {
  for (Eigen::Vector2d& point : curve) {
    if (point.y() <= 0.0) point.y() = std::numeric_limits<double>::quiet_NaN();
  }
  return curve;
}

}  // namespace

ReportFigure draw_power_frames(const std::filesystem::path& folder,
                               const std::vector<Pose3>& frames) {
  Figure figure(folder, "fig2_frames", 760, 560);
  figure.title("Frames between two frames", "τ_a^(1−u) τ_b^u for 11 values of u; axes of 1 m");
  figure << "set view 62,338,1.7"
         << "set view equal xyz"
         << "set key at screen 0.97,0.8"
         << "set xyplane relative 0.05"
         << "set border 31"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'"
         << "set zlabel 'z (m)' rotate by 90"
         << "set xtics 2\nset ytics 2\nset ztics 2";
  const std::array<const char*, 3> colours = {kRed, kGreen, kBlue};
  const std::array<const char*, 3> names = {"x", "y", "z"};
  std::string command;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const std::string block =
        figure.data(std::string(names[k]) + " axes: x y z dx dy dz", axis_columns(frames, axis));
    command += (command.empty() ? "splot " : ", ") + block +
               " using 1:2:3:4:5:6 with vectors head filled size 0.12,18 lw 1.8 lc " + colours[k] +
               " title '" + names[k] + " axis'";
  }
  figure << command;
  return figure.draw("Figure 2: interpolated frames",
                     "Both frames and nine between them: position and axes turn together along "
                     "one smooth way.");
}

ReportFigure draw_power_errors(const std::filesystem::path& folder, const PowerErrors& errors,
                               double paper_error) {
  Figure figure(folder, "fig3_errors", 820, 520);
  figure.title("What a power and its inverse lose", "mean over 300 random transforms");
  figure << "set logscale y"
         << "set format y '10^{%L}'"
         << "set yrange [1e-17:1e-1]"
         << "set xrange [0:1]"
         << "set xlabel 'power u'"
         << "set ylabel 'error (Frobenius norm)'";
  figure.key_below(125);
  figure.plot(
      {figure.data("inverse power: u error", without_zeros(errors.inverse_power)) +
           " with linespoints lw 1.6 pt 7 ps 0.3 lc " + kBlue + " title 'power u, then power 1/u'",
       figure.data("products: u error", without_zeros(errors.product)) +
           " with linespoints lw 1.6 pt 7 ps 0.4 lc " + kRed + " title 'power u, then 1/u factors'",
       number(paper_error) + " with lines dt 2 lw 1.6 lc " + kGrey +
           " title 'the paper, factors: 4.8e-3'"});
  return figure.draw("Figure 3: power and inverse power",
                     "Both stay at the rounding of doubles, also for small u.");
}

}  // namespace honka::eval
