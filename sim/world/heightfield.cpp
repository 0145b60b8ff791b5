#include "sim/world/heightfield.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka::sim {

Heightfield::Heightfield(Eigen::Vector2d origin_m, double cell_m, int nx, int ny,
                         std::vector<double> heights_m)
    : origin_m_(std::move(origin_m)),
      cell_m_(cell_m),
      nx_(nx),
      ny_(ny),
      heights_m_(std::move(heights_m)) {
  HONKA_CHECK(nx >= 2 && ny >= 2 && cell_m > 0.0, "a height field needs at least 2 × 2 nodes");
  HONKA_CHECK(heights_m_.size() == static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny),
              "one height a node");
}

double Heightfield::height_m(const Eigen::Vector2d& position_m) const {
  if (heights_m_.empty()) return 0.0;
  const Eigen::Vector2d grid = (position_m - origin_m_) / cell_m_;
  const double gx = std::clamp(grid.x(), 0.0, static_cast<double>(nx_ - 1));
  const double gy = std::clamp(grid.y(), 0.0, static_cast<double>(ny_ - 1));
  const int ix = std::min(static_cast<int>(gx), nx_ - 2);
  const int iy = std::min(static_cast<int>(gy), ny_ - 2);
  const double fx = gx - ix;
  const double fy = gy - iy;
  const auto at = [&](int x, int y) {
    return heights_m_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                      static_cast<std::size_t>(x)];
  };
  return (1 - fy) * ((1 - fx) * at(ix, iy) + fx * at(ix + 1, iy)) +
         fy * ((1 - fx) * at(ix, iy + 1) + fx * at(ix + 1, iy + 1));
}

Eigen::Vector3d Heightfield::normal(const Eigen::Vector2d& position_m) const {
  const double step = 0.5 * cell_m_;
  const Eigen::Vector2d dx(step, 0), dy(0, step);
  const double slope_x = (height_m(position_m + dx) - height_m(position_m - dx)) / (2 * step);
  const double slope_y = (height_m(position_m + dy) - height_m(position_m - dy)) / (2 * step);
  return Eigen::Vector3d(-slope_x, -slope_y, 1.0).normalized();
}

TriangleMesh Heightfield::mesh() const {
  TriangleMesh mesh;
  mesh.label = {-1, Part::kGround};
  for (int iy = 0; iy < ny_; ++iy) {
    for (int ix = 0; ix < nx_; ++ix) {
      const Eigen::Vector2d p = origin_m_ + cell_m_ * Eigen::Vector2d(ix, iy);
      mesh.vertices_m.push_back(Eigen::Vector3d(p.x(), p.y(), height_m(p)).cast<float>());
    }
  }
  const auto node = [&](int ix, int iy) { return static_cast<std::uint32_t>(iy * nx_ + ix); };
  for (int iy = 0; iy + 1 < ny_; ++iy) {
    for (int ix = 0; ix + 1 < nx_; ++ix) {
      mesh.triangles.push_back({node(ix, iy), node(ix + 1, iy), node(ix + 1, iy + 1)});
      mesh.triangles.push_back({node(ix, iy), node(ix + 1, iy + 1), node(ix, iy + 1)});
    }
  }
  return mesh;
}

double Heightfield::relief_m() const {
  if (heights_m_.empty()) return 0.0;
  const auto [low, high] = std::minmax_element(heights_m_.begin(), heights_m_.end());
  return *high - *low;
}

}  // namespace honka::sim
