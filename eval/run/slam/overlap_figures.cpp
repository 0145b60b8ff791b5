#include "eval/run/slam/overlap_figures.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

constexpr double kRowM = 0.1;  // rows that fill the common area

/// The cone's edge as a closed line, in the frame that `T` maps into.
std::vector<Eigen::Vector2d> cone_outline(const Pose2& T, const ViewCone& cone) {
  std::vector<Eigen::Vector2d> line = {T.translation_m};
  const double half_rad = deg_to_rad(0.5 * cone.angle_deg);
  for (int k = 0; k <= 120; ++k) {
    const double azimuth_rad = half_rad * (k / 60.0 - 1.0);
    line.push_back(T *
                   (cone.range_m * Eigen::Vector2d(std::cos(azimuth_rad), std::sin(azimuth_rad))));
  }
  line.push_back(T.translation_m);
  return line;
}

/// Pieces of close rows that lie in both cones.
std::vector<std::vector<Eigen::Vector2d>> common_rows(const Pose2& T_target_source,
                                                      const ViewCone& cone) {
  const Pose2 T_source_target = T_target_source.inverse();
  std::vector<std::vector<Eigen::Vector2d>> rows;
  for (double y = -cone.range_m; y <= cone.range_m; y += kRowM) {
    std::vector<Eigen::Vector2d> piece;
    for (double x = -cone.range_m; x <= cone.range_m; x += kRowM) {
      const Eigen::Vector2d place(x, y);
      const bool common = cone.holds(place) && cone.holds(T_source_target * place);
      if (common && piece.size() == 2) piece.back() = place;
      if (common && piece.size() < 2) piece.push_back(place);
      if (!common && !piece.empty()) rows.push_back(std::exchange(piece, {}));
    }
    if (!piece.empty()) rows.push_back(piece);
  }
  return rows;
}

std::string heading_arrow(const Pose2& T, const char* colour) {
  const Eigen::Vector2d tip = T * Eigen::Vector2d(6.0, 0.0);
  return fmt::format("set arrow from {:g},{:g} to {:g},{:g} lw 2.5 lc {} front",
                     T.translation_m.x(), T.translation_m.y(), tip.x(), tip.y(), colour);
}

}  // namespace

ReportFigure draw_overlap_cones(const std::filesystem::path& folder, const Pose2& T_target_source,
                                const ViewCone& cone, double overlap) {
  Figure figure(folder, "fig8_cones", 760, 700);
  figure.title("Overlap of two view cones",
               fmt::format("{:g} m, {:g}°: λ = {:.3f}", cone.range_m, cone.angle_deg, overlap));
  figure << "set size ratio -1"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'"
         << "set xtics 10\nset ytics 10" << heading_arrow(Pose2{}, kBlue)
         << heading_arrow(T_target_source, kRed);
  figure.key_below(115);
  const auto line = [&](const char* what, const Pose2& T, const char* colour) {
    return figure.data(std::string(what) + ": x y", cone_outline(T, cone)) +
           " with lines lw 2 lc " + colour + " title '" + what + "'";
  };
  figure.plot({figure.lines("common area: x y", common_rows(T_target_source, cone)) +
                   " with lines lw 1.4 lc '#BBBBBB' title 'seen by both'",
               line("view j", Pose2{}, kBlue), line("view i", T_target_source, kRed)});
  return figure.draw("Figure 8: overlap of view cones",
                     "λ is the grey area as a part of one cone. Arrows: where the scanners face.");
}

ReportFigure draw_overlap_errors(const std::filesystem::path& folder,
                                 const std::vector<OverlapError>& errors) {
  std::vector<Eigen::Vector2d> rms, largest;
  for (const OverlapError& e : errors) {
    rms.emplace_back(e.samples, e.rms);
    largest.emplace_back(e.samples, e.largest);
  }
  Figure figure(folder, "fig8_samples", 820, 520);
  figure.title("How well so many samples know the overlap", "300 random pairs of views");
  figure << "set logscale xy"
         << "set xlabel 'samples'"
         << "set ylabel 'error of λ'"
         << "set xrange [12:22000]"
         << "set xtics (16,64,256,1024,4096,16384)"
         << "set arrow from 256, graph 0 to 256, graph 1 nohead dt 3 lc '#8A8A8A'";
  figure.key_below(115);
  figure.plot({figure.data("largest: samples error", largest) +
                   " with linespoints lw 1.6 pt 7 ps 0.6 lc " + kRed + " title 'largest'",
               figure.data("rms: samples error", rms) + " with linespoints lw 1.6 pt 7 ps 0.6 lc " +
                   kBlue + " title 'RMS'"});
  return figure.draw("Figure 8: sampling error of λ",
                     "Dotted: the 256 samples that are used everywhere.");
}

}  // namespace honka::eval
