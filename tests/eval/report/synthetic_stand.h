#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algo/types/angles.h"
#include "algo/types/random.h"
#include "algo/types/stem.h"
#include "eval/report/figure_matched_stars.h"

namespace honka::test {

/// Stems on a jittered grid.
inline StemMap synthetic_stand(double width_m, double depth_m, int count) {
  StemMap stems;
  RandomStream random(11, "synthetic_stand", {});
  const double step = std::sqrt(width_m * depth_m / count);
  for (double x = 0.5 * step; x < width_m; x += step) {
    for (double y = 0.5 * step; y < depth_m; y += step) {
      Stem stem;
      stem.position_m = {x + 0.6 * step * (random.uniform() - 0.5),
                         y + 0.6 * step * (random.uniform() - 0.5)};
      stem.dbh_m = 0.15 + 0.2 * random.uniform();
      stems.push_back(stem);
    }
  }
  return stems;
}

/// Ground, trunks and crowns over a stand, so many points a stem.
inline std::vector<Eigen::Vector3d> synthetic_cloud(const StemMap& stand, int per_stem) {
  std::vector<Eigen::Vector3d> cloud;
  RandomStream random(12, "synthetic_cloud", {});
  for (const Stem& stem : stand) {
    for (int i = 0; i < per_stem; ++i) {
      const double kind = random.uniform(), angle = 2.0 * kPi * random.uniform();
      const double spread = kind < 0.35 ? 2.5 : (kind < 0.7 ? 0.13 : 1.4 * random.uniform());
      const double z = kind < 0.35  ? 0.1 * random.normal()
                       : kind < 0.7 ? 9.0 * random.uniform()
                                    : 9.0 + 9.0 * random.uniform();
      cloud.emplace_back(stem.position_m.x() + spread * std::cos(angle),
                         stem.position_m.y() + spread * std::sin(angle),
                         z + 0.01 * stem.position_m.x());
    }
  }
  return cloud;
}

/// A triangulation of a jittered lattice around the origin, and its stars.
struct SyntheticGraph {
  eval::Edges edges;
  std::vector<eval::StarVertices> stars;
};

inline SyntheticGraph synthetic_graph() {
  constexpr int kSize = 10;
  std::array<std::array<Eigen::Vector2d, kSize>, kSize> p;
  RandomStream random(13, "synthetic_graph", {});
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j < kSize; ++j) {
      p[i][j] = {5.0 * (i - 4) + 2.0 * random.uniform(), 5.0 * (j - 5) + 2.0 * random.uniform()};
    }
  }
  SyntheticGraph graph;
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j < kSize; ++j) {
      if (i + 1 < kSize) graph.edges.push_back({p[i][j], p[i + 1][j]});
      if (j + 1 < kSize) graph.edges.push_back({p[i][j], p[i][j + 1]});
      if (i + 1 < kSize && j + 1 < kSize) graph.edges.push_back({p[i + 1][j], p[i][j + 1]});
      if (i > 0 && j > 0 && i + 1 < kSize && j + 1 < kSize) {
        graph.stars.push_back(
            {p[i][j], p[i + 1][j], p[i][j + 1], p[i + 1][j + 1], p[i - 1][j + 1], p[i + 1][j - 1]});
      }
    }
  }
  return graph;
}

}  // namespace honka::test
