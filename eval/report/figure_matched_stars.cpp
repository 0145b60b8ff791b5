#include "eval/report/figure_matched_stars.h"

#include <algorithm>

#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

using Polylines = std::vector<std::vector<Eigen::Vector2d>>;

struct Box {
  Eigen::Vector2d low, high;
};

Box box_of(const std::vector<StarVertices>& stars, double margin_m) {
  if (stars.empty()) return {{-margin_m, -margin_m}, {margin_m, margin_m}};
  Box box{stars[0][0], stars[0][0]};
  for (const StarVertices& star : stars) {
    for (const auto& vertex : star) {
      box.low = box.low.cwiseMin(vertex);
      box.high = box.high.cwiseMax(vertex);
    }
  }
  box.low.array() -= margin_m;
  box.high.array() += margin_m;
  return box;
}

Polylines edges_inside(const Edges& edges, const Box& box) {
  Polylines inside;
  for (const auto& edge : edges) {
    const bool seen = std::any_of(edge.begin(), edge.end(), [&](const Eigen::Vector2d& p) {
      return (p.array() >= box.low.array()).all() && (p.array() <= box.high.array()).all();
    });
    if (seen) inside.push_back({edge[0], edge[1]});
  }
  return inside;
}

Polylines outlines(const std::vector<StarVertices>& stars, bool centres) {
  Polylines all;
  for (const StarVertices& star : stars) {
    const Polylines lines = star_outlines(star);
    if (centres) {
      all.push_back(lines.front());
    } else {
      all.insert(all.end(), lines.begin() + 1, lines.end());
    }
  }
  return all;
}

void set_ranges(Figure& figure, const Box& box) {
  figure << "set xrange [" + number(box.low.x()) + ":" + number(box.high.x()) + "]"
         << "set yrange [" + number(box.low.y()) + ":" + number(box.high.y()) + "]";
}

/// One panel: the triangulation, and stars with filled centres upon it.
void panel(Figure& figure, const std::string& name, const Edges& edges,
           const std::vector<StarVertices>& stars, const Box& box, const std::string& colour) {
  const std::string graph = figure.lines(name + " triangulation: x y", edges_inside(edges, box));
  const std::string centre = figure.lines(name + " triangles: x y", outlines(stars, true));
  const std::string around = figure.lines(name + " neighbours: x y", outlines(stars, false));
  set_ranges(figure, box);
  figure.plot(
      {graph + " with lines lw 0.6 lc '#B0B0B0' notitle",
       around + " with filledcurves closed fs transparent solid 0.18 lc " + colour + " notitle",
       around + " with lines lw 0.8 lc " + colour + " notitle",
       centre + " with filledcurves closed fs transparent solid 0.65 lc " + colour + " notitle",
       graph + " with points pt 7 ps 0.25 lc '#555555' notitle"});
}

}  // namespace

Polylines star_outlines(const StarVertices& s) {
  return {{s[0], s[1], s[2], s[0]},
          {s[1], s[2], s[3], s[1]},
          {s[2], s[0], s[4], s[2]},
          {s[0], s[1], s[5], s[0]}};
}

ReportFigure draw_matched_stars(const std::filesystem::path& folder,
                                const MatchedStarsFigure& input) {
  Figure figure(folder, "matched_stars", 1200, 520);
  std::vector<StarVertices> local = input.local_stars;
  local.push_back(input.target);
  const Box local_box = box_of(local, 8.0);
  figure << "set multiplot layout 1,3 title " +
                gnuplot_text("Matching triangles with their neighbours: " + input.protocol) +
                " font ',14'"
         << "set size ratio -1"
         << "unset key"
         << "unset grid"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)' offset 1";
  figure.title("(a) target star", "local triangulation");
  panel(figure, "target", input.local_edges, {input.target}, box_of({input.target}, 8.0), kRed);
  figure.title("(b) all " + std::to_string(input.local_stars.size()) + " matched stars",
               "local triangulation; the sensor at the origin");
  panel(figure, "local", input.local_edges, input.local_stars, local_box, kBlue);
  figure.title("(c) their partners", "triangulation of the map");
  panel(figure, "map", input.map_edges, input.map_stars, box_of(input.map_stars, 8.0), kGreen);
  figure << "unset multiplot";
  return figure.draw("Matched stars (the paper's Figure 6)",
                     "(a) One triangle (dark) with its three neighbours (light) in the local "
                     "graph; (b) every local triangle that found a partner; (c) the partners in "
                     "the map, in the map's own frame.");
}

}  // namespace honka::eval
