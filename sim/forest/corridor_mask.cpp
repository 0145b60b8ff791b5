#include "sim/forest/corridor_mask.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka::sim {
namespace {

constexpr double kCell_m = 5.0;

int cell_of(double offset_m, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / kCell_m), 0.0, count - 1.0));
}

}  // namespace

double distance_to_segment_m(const Eigen::Vector2d& point_m, const Eigen::Vector2d& a_m,
                             const Eigen::Vector2d& b_m) {
  const Eigen::Vector2d along = b_m - a_m;
  const double length2 = along.squaredNorm();
  const double share =
      length2 > 0.0 ? std::clamp((point_m - a_m).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (point_m - a_m - share * along).norm();
}

CorridorMask::CorridorMask(const std::vector<Polyline>& corridors, double half_width_m,
                           const Eigen::AlignedBox2d& box_m)
    : half_width_m_(half_width_m), box_m_(box_m) {
  const Eigen::Vector2d sizes = box_m.sizes();
  nx_ = std::max(1, static_cast<int>(std::ceil(sizes.x() / kCell_m)));
  ny_ = std::max(1, static_cast<int>(std::ceil(sizes.y() / kCell_m)));
  cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
  for (const Polyline& line : corridors) {
    for (const auto& point : line) HONKA_CHECK(point.allFinite(), "corridors are finite");
    if (line.size() == 1) insert({line[0], line[0]});
    for (std::size_t i = 1; i < line.size(); ++i) insert({line[i - 1], line[i]});
  }
}

void CorridorMask::insert(const Segment& segment) {
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(half_width_m_);
  const Eigen::Vector2d low = segment.a_m.cwiseMin(segment.b_m) - reach;
  const Eigen::Vector2d high = segment.a_m.cwiseMax(segment.b_m) + reach;
  if (!Eigen::AlignedBox2d(low, high).intersects(box_m_)) return;
  const auto index = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back(segment);
  const int x1 = cell_of(high.x() - box_m_.min().x(), nx_);
  const int y1 = cell_of(high.y() - box_m_.min().y(), ny_);
  for (int y = cell_of(low.y() - box_m_.min().y(), ny_); y <= y1; ++y) {
    for (int x = cell_of(low.x() - box_m_.min().x(), nx_); x <= x1; ++x) {
      cells_[static_cast<std::size_t>(y * nx_ + x)].push_back(index);
    }
  }
}

bool CorridorMask::contains(const Eigen::Vector2d& position_m) const {
  if (segments_.empty()) return false;
  const Eigen::Vector2d offset = position_m - box_m_.min();
  const auto& near =
      cells_[static_cast<std::size_t>(cell_of(offset.y(), ny_) * nx_ + cell_of(offset.x(), nx_))];
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t i) {
    return distance_to_segment_m(position_m, segments_[i].a_m, segments_[i].b_m) < half_width_m_;
  });
}

}  // namespace honka::sim
