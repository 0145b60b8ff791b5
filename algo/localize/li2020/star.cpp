#include "algo/localize/li2020/star.h"

#include <algorithm>
#include <cmath>

namespace honka {
namespace {

double dissimilarity(const TriangleStar& local, std::size_t i, const TriangleStar& map,
                     std::size_t j) {
  return std::abs(map.area_m2[j] - local.area_m2[i]) +
         std::abs(map.perimeter_squared_m2[j] - local.perimeter_squared_m2[i]);
}

/// The corner of a neighbour that the centre does not share.
std::int32_t apex(const DelaunayTriangle& neighbour, std::int32_t centre) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (neighbour.neighbours[k] == centre) return neighbour.vertices[k];
  }
  return -1;
}

bool is_centre(const DelaunayGraph& graph, const DelaunayTriangle& triangle, StarChoice choice) {
  const bool three = std::all_of(triangle.neighbours.begin(), triangle.neighbours.end(),
                                 [](std::int32_t n) { return n >= 0; });
  if (!three || choice == StarChoice::kThreeNeighbours) return three;
  return std::none_of(triangle.vertices.begin(), triangle.vertices.end(), [&](std::int32_t v) {
    return graph.on_hull[static_cast<std::size_t>(v)] != 0;
  });
}

}  // namespace

std::vector<TriangleStar> stars_of(const DelaunayGraph& graph, StarChoice choice) {
  std::vector<TriangleStar> stars;
  for (std::size_t i = 0; i < graph.triangles.size(); ++i) {
    const DelaunayTriangle& centre = graph.triangles[i];
    if (!is_centre(graph, centre, choice)) continue;
    // Li2020 Eq. (1)
    TriangleStar star;
    star.triangle = static_cast<std::int32_t>(i);
    star.area_m2[0] = centre.area_m2;
    star.perimeter_squared_m2[0] = centre.perimeter_squared_m2;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& neighbour = graph.triangles[static_cast<std::size_t>(centre.neighbours[k])];
      star.vertices[k] = centre.vertices[k];
      star.vertices[k + 3] = apex(neighbour, star.triangle);
      star.area_m2[k + 1] = neighbour.area_m2;
      star.perimeter_squared_m2[k + 1] = neighbour.perimeter_squared_m2;
    }
    stars.push_back(star);
  }
  return stars;
}

double centre_dissimilarity_m2(const TriangleStar& local, const TriangleStar& map) {
  return dissimilarity(local, 0, map, 0);
}

std::optional<StarLikeness> compare_stars(const TriangleStar& local, const TriangleStar& map,
                                          double tolerance_m2, int neighbours_required) {
  const double centre = dissimilarity(local, 0, map, 0);
  if (!(centre <= tolerance_m2)) return std::nullopt;
  std::optional<StarLikeness> best;
  for (std::size_t rotation = 0; rotation < 3; ++rotation) {
    double total = centre;
    int within = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = dissimilarity(local, k + 1, map, (k + rotation) % 3 + 1);
      total += d;
      within += d <= tolerance_m2 ? 1 : 0;
    }
    if (within < neighbours_required) continue;
    if (!best || total < best->dissimilarity_m2) best = {static_cast<int>(rotation), total};
  }
  return best;
}

}  // namespace honka
