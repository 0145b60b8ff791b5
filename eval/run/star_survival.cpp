#include "eval/run/star_survival.h"

#include <algorithm>
#include <array>

#include "algo/geometry/kdtree.h"

namespace honka::eval {
namespace {

using Corners = std::array<std::int32_t, 3>;

Corners sorted(Corners corners) {
  std::sort(corners.begin(), corners.end());
  return corners;
}

bool touches_hull(const DelaunayGraph& graph, const DelaunayTriangle& triangle) {
  return std::any_of(triangle.vertices.begin(), triangle.vertices.end(), [&](std::int32_t v) {
    return graph.on_hull[static_cast<std::size_t>(v)] != 0;
  });
}

/// Map vertex of each local vertex, −1 where no stem of the map is near.
std::vector<std::int32_t> follow(const DelaunayGraph& local, const DelaunayGraph& map,
                                 const Pose2& T_map_local, double gate_m) {
  const KdTree2 tree(map.vertices);
  std::vector<std::int32_t> followed;
  for (const Eigen::Vector2d& vertex : local.vertices) {
    const auto nearest = tree.nearest(T_map_local * vertex);
    const bool near = nearest && nearest->distance_m <= gate_m;
    followed.push_back(near ? static_cast<std::int32_t>(nearest->index) : -1);
  }
  return followed;
}

}  // namespace

StarSurvival star_survival(const DelaunayGraph& local, const DelaunayGraph& map,
                           const Pose2& T_map_local, double gate_m) {
  StarSurvival result;
  if (local.triangles.empty() || map.triangles.empty()) return result;
  std::vector<Corners> map_triangles;
  for (const DelaunayTriangle& triangle : map.triangles) {
    map_triangles.push_back(sorted(triangle.vertices));
  }
  std::sort(map_triangles.begin(), map_triangles.end());
  const std::vector<std::int32_t> followed = follow(local, map, T_map_local, gate_m);
  const auto survives = [&](const DelaunayTriangle& triangle) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = followed[static_cast<std::size_t>(triangle.vertices[k])];
    }
    return std::binary_search(map_triangles.begin(), map_triangles.end(), sorted(corners));
  };
  for (const DelaunayTriangle& triangle : local.triangles) {
    if (touches_hull(local, triangle)) continue;
    ++result.stars;
    const bool whole =
        survives(triangle) &&
        std::all_of(triangle.neighbours.begin(), triangle.neighbours.end(), [&](std::int32_t n) {
          return n >= 0 && survives(local.triangles[static_cast<std::size_t>(n)]);
        });
    if (whole) ++result.surviving;
  }
  return result;
}

}  // namespace honka::eval
