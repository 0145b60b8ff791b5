#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/world/world.h"

namespace honka::sim {

/// Ground height on a square grid, bilinear between nodes, clamped to its border outside.
class Heightfield {
 public:
  Heightfield() = default;
  /// `heights_m` by rows of x (index = iy · nx + ix); node (0, 0) lies at `origin_m`.
  Heightfield(Eigen::Vector2d origin_m, double cell_m, int nx, int ny,
              std::vector<double> heights_m);

  [[nodiscard]] double height_m(const Eigen::Vector2d& position_m) const;
  /// Unit normal of the surface, pointing up.
  [[nodiscard]] Eigen::Vector3d normal(const Eigen::Vector2d& position_m) const;
  [[nodiscard]] TriangleMesh mesh() const;
  [[nodiscard]] double relief_m() const;  ///< highest less lowest node

 private:
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  double cell_m_ = 1.0;
  int nx_ = 0, ny_ = 0;
  std::vector<double> heights_m_;
};

}  // namespace honka::sim
