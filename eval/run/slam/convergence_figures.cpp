#include "eval/run/slam/convergence_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

/// The heights' palette turned round: where ICP succeeds it is bright, and contours stand out.
constexpr const char* kLowIsBright =
    "set palette defined (0 '#FDE725', 1 '#7AD151', 2 '#22A884', 3 '#2A788E', 4 '#414487', "
    "5 '#440154')";

using ConvergenceValue = double (*)(const ConvergencePoint&);

/// One figure over the grid: what is shown, at which levels it has contours.
struct GridView {
  const char *name, *title, *scale, *palette;
  ConvergenceValue value;
  std::array<double, 2> levels;
  std::array<const char*, 2> level_labels;
};

/// Column by column, for gnuplot's "matrix".
std::vector<std::vector<double>> grid_columns(const ConvergenceGrid& grid, ConvergenceValue value) {
  std::vector<std::vector<double>> columns(static_cast<std::size_t>(grid.columns));
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      columns[static_cast<std::size_t>(column)].push_back(
          value(grid.points[static_cast<std::size_t>(row * grid.columns + column)]));
    }
  }
  return columns;
}

bool is_crossed(const ConvergenceGrid& grid, ConvergenceValue value, double level) {
  const auto [low, high] =
      std::minmax_element(grid.points.begin(), grid.points.end(),
                          [&](const auto& a, const auto& b) { return value(a) < value(b); });
  return value(*low) < level && level < value(*high);
}

/// Lines of the contour at each level, as gnuplot's data blocks $level0, $level1.
void make_contours(Figure& figure, const std::string& surface, const ConvergenceGrid& grid,
                   const GridView& view) {
  figure << "set contour base\nunset surface";
  for (std::size_t k = 0; k < view.levels.size(); ++k) {
    if (!is_crossed(grid, view.value, view.levels[k])) continue;
    figure << fmt::format("set cntrparam levels discrete {:g}", view.levels[k])
           << fmt::format("set table $level{}", k) << "splot " + surface << "unset table";
  }
  figure << "unset contour\nset surface";
}

/// From the outer edge of the first cell to that of the last.
std::string range_of(const char* axis, double step, int count) {
  return fmt::format("set {}range [{:g}:{:g}]", axis, -0.5 * step, step * (count - 0.5));
}

ReportFigure draw_grid(const std::filesystem::path& folder, const ConvergenceGrid& grid,
                       const GridView& view, const std::string& caption) {
  Figure figure(folder, view.name, 860, 700);
  figure.title(view.title, fmt::format("{} starts a place", grid.points.front().starts));
  const std::string block =
      figure.data("rows: turn, columns: shift", grid_columns(grid, view.value));
  const std::string surface = block + fmt::format(" matrix using ($1*{:g}):($2*{:g}):3",
                                                  grid.shift_step_m, grid.turn_step_deg);
  make_contours(figure, surface, grid, view);
  figure << "set xlabel 'shift δ of the start (m)'"
         << "set ylabel 'turn θ of the start (°)'" << range_of("x", grid.shift_step_m, grid.columns)
         << range_of("y", grid.turn_step_deg, grid.rows)
         << "set cblabel '" + std::string(view.scale) + "'" << view.palette;
  figure.key_below(190);
  std::vector<std::string> elements = {surface + " with image notitle"};
  const std::array<const char*, 2> dashes = {"dt 1", "dt 2"};
  for (std::size_t k = 0; k < view.levels.size(); ++k) {
    if (!is_crossed(grid, view.value, view.levels[k])) continue;
    elements.push_back(fmt::format("$level{} using 1:2 with lines lw 2.4 {} lc 'black' title '{}'",
                                   k, dashes[k], view.level_labels[k]));
  }
  const std::array<const char*, 3> colours = {kRed, kOrange, kSky};
  for (std::size_t k = 0; k < grid.arcs.size(); ++k) {
    std::vector<Eigen::Vector2d> arc;
    for (const StartError& start : starts_on_ellipse(grid.arcs[k].shift_m, grid.arcs[k].turn_deg)) {
      arc.emplace_back(start.shift_m, start.turn_deg);
    }
    elements.push_back(figure.data(grid.arcs[k].label + ": shift turn", arc) +
                       " with lines lw 2.6 lc " + colours[k % 3] + " title " +
                       gnuplot_text(grid.arcs[k].label));
  }
  figure.plot(elements);
  return figure.draw(view.title, caption);
}

std::vector<Eigen::Vector2d> from_the_side(const std::vector<Eigen::Vector3d>& points_m) {
  std::vector<Eigen::Vector2d> side;
  for (const Eigen::Vector3d& p : points_m) side.emplace_back(p.x(), p.z());
  return side;
}

}  // namespace

ReportFigure draw_convergence_error(const std::filesystem::path& folder,
                                    const ConvergenceGrid& grid) {
  const GridView view = {"fig6_error",
                         "Match error of ICP by how far off it starts",
                         "mean e (m)",
                         kLowIsBright,
                         [](const ConvergencePoint& p) { return p.error_m; },
                         {0.2, 0.7},
                         {"e = 0.2 m", "e = 0.7 m"}};
  return draw_grid(folder, grid, view,
                   "Black: contours of the mean e. Coloured: the quarter ellipses within which "
                   "Eq. 26 takes ICP to succeed.");
}

ReportFigure draw_convergence_success(const std::filesystem::path& folder,
                                      const ConvergenceGrid& grid) {
  const GridView view = {"fig6_success",
                         "Success of ICP by how far off it starts",
                         "part of the starts that end at the truth",
                         kHeightPalette,
                         [](const ConvergencePoint& p) { return p.success; },
                         {0.9, 0.95},
                         {"90 %", "95 %"}};
  return draw_grid(folder, grid, view,
                   "The same starts, judged by the truth: within 0.5 m and 2°.");
}

ReportFigure draw_tilt_scene(const std::filesystem::path& folder, const TiltScene& scene) {
  Figure figure(folder, "fig7_scene", 900, 330);
  figure.title("Two frames of the same stems, one tilted",
               fmt::format("{:g}° about the y axis; from the side", scene.tilt_deg));
  figure << "set size ratio -1"
         << "set xlabel 'x ahead (m)'"
         << "set ylabel 'z (m)'";
  figure.key_below(115);
  figure.plot({figure.data("frame j: x z", from_the_side(scene.target_m)) +
                   " with points pt 7 ps 0.45 lc " + kBlue + " title 'frame j'",
               figure.data("frame i tilted: x z", from_the_side(scene.tilted_m)) +
                   " with points pt 5 ps 0.45 lc " + kRed + " title 'frame i, tilted'"});
  return figure.draw("Figure 7: a tilted start",
                     "The cloud is flat, so a tilt moves stems up and down more than sideways.");
}

ReportFigure draw_tilt_curves(const std::filesystem::path& folder,
                              const std::vector<ConvergencePoint>& points, double paper_limit_deg) {
  std::vector<Eigen::Vector2d> error, success;
  for (const ConvergencePoint& p : points) {
    error.emplace_back(p.start.tilt_deg, p.error_m);
    success.emplace_back(p.start.tilt_deg, p.success);
  }
  Figure figure(folder, "fig7_tilt", 860, 540);
  figure.title("ICP from tilted starts", fmt::format("{} starts a tilt", points.front().starts));
  figure << "set xlabel 'tilt φ of the start (°)'"
         << "set ylabel 'mean e (m)'"
         << "set y2label 'part that ends at the truth'"
         << "set border 11\nset ytics nomirror\nset y2tics\nset y2range [0:1.05]\nset yrange [0:*]"
         << fmt::format("set arrow from {0:g}, graph 0 to {0:g}, graph 1 nohead dt 2 lw 1.6 lc {1}",
                        paper_limit_deg, kGrey);
  figure.key_below(125);
  figure.plot({figure.data("success: tilt part", success) +
                   " axes x1y2 with linespoints lw 1.6 pt 7 ps 0.5 lc " + kBlue +
                   " title 'success (right axis)'",
               figure.data("error: tilt e", error) + " with linespoints lw 1.6 pt 5 ps 0.5 lc " +
                   kRed + " title 'mean e'",
               std::string("NaN with lines dt 2 lw 1.6 lc ") + kGrey +
                   fmt::format(" title 'the paper: {:g}°'", paper_limit_deg)});
  return figure.draw("Figure 7: ICP over the tilt of the start",
                     "No shift and no turn; the axis of the tilt lies in four directions.");
}

}  // namespace honka::eval
