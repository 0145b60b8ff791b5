#include "sim/forest/spacing/torus_grid.h"

#include "algo/types/check.h"

namespace honka::sim {

TorusGrid::TorusGrid(const Eigen::AlignedBox2d& box_m, double reach_m)
    : low_m_(box_m.min()), sizes_m_(box_m.sizes()) {
  HONKA_CHECK(reach_m > 0.0 && sizes_m_.minCoeff() > 0.0, "a grid needs a box and a reach");
  constexpr int kMostCells = 4096;
  nx_ = std::clamp(static_cast<int>(sizes_m_.x() / reach_m), 1, kMostCells);
  ny_ = std::clamp(static_cast<int>(sizes_m_.y() / reach_m), 1, kMostCells);
  cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
}

void TorusGrid::add(const Eigen::Vector2d& position_m) {
  cell(position_m).push_back(static_cast<std::uint32_t>(points_m_.size()));
  points_m_.push_back(position_m);
}

void TorusGrid::move(std::size_t index, const Eigen::Vector2d& position_m) {
  auto& from = cell(points_m_[index]);
  auto& to = cell(position_m);
  points_m_[index] = position_m;
  if (&from == &to) return;
  from.erase(std::find(from.begin(), from.end(), static_cast<std::uint32_t>(index)));
  to.push_back(static_cast<std::uint32_t>(index));
}

}  // namespace honka::sim
