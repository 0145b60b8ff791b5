#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace honka::sim {

/// Moving points in a box whose opposite sides touch, by cells of at least `reach_m`.
class TorusGrid {
 public:
  TorusGrid(const Eigen::AlignedBox2d& box_m, double reach_m);

  /// Adds a point inside the box; points are numbered 0, 1, … in the order they are added.
  void add(const Eigen::Vector2d& position_m);
  void move(std::size_t index, const Eigen::Vector2d& position_m);
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points_m() const { return points_m_; }

  /// Calls `visit(index, squared distance)` for every point nearer than the reach, and for some
  /// that are farther.
  template <typename Visit>
  void near(const Eigen::Vector2d& position_m, const Visit& visit) const {
    const int cx = column(position_m), cy = row(position_m);
    const int spread_x = std::min(3, nx_), spread_y = std::min(3, ny_);
    for (int j = 0; j < spread_y; ++j) {
      const int y = (cy + ny_ - 1 + j) % ny_;
      for (int i = 0; i < spread_x; ++i) {
        const int x = (cx + nx_ - 1 + i) % nx_;
        for (const std::uint32_t index : cells_[static_cast<std::size_t>(y * nx_ + x)]) {
          visit(static_cast<std::size_t>(index), distance2(position_m, points_m_[index]));
        }
      }
    }
  }

 private:
  [[nodiscard]] int column(const Eigen::Vector2d& p) const {
    return std::clamp(static_cast<int>((p.x() - low_m_.x()) / sizes_m_.x() * nx_), 0, nx_ - 1);
  }
  [[nodiscard]] int row(const Eigen::Vector2d& p) const {
    return std::clamp(static_cast<int>((p.y() - low_m_.y()) / sizes_m_.y() * ny_), 0, ny_ - 1);
  }
  [[nodiscard]] std::vector<std::uint32_t>& cell(const Eigen::Vector2d& p) {
    return cells_[static_cast<std::size_t>(row(p) * nx_ + column(p))];
  }
  [[nodiscard]] double distance2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
    double dx = std::abs(a.x() - b.x()), dy = std::abs(a.y() - b.y());
    dx = std::min(dx, sizes_m_.x() - dx);
    dy = std::min(dy, sizes_m_.y() - dy);
    return dx * dx + dy * dy;
  }

  Eigen::Vector2d low_m_, sizes_m_;
  int nx_ = 1, ny_ = 1;
  std::vector<Eigen::Vector2d> points_m_;
  std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace honka::sim
