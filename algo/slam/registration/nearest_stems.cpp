#include "algo/slam/registration/nearest_stems.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace honka {
namespace {

constexpr double kStemsPerCell = 1.0;  // fastest of 0.5 … 4 for 110 stems
constexpr double kLongestSide = 64.0;  // cells; bounds the memory of clouds along a line
constexpr double kLeastCellM = 1e-3;

/// The cell of a coordinate; the first and the last one for all that lies outside.
int stem_cell(double coordinate, double low, double per_m, int count) {
  return static_cast<int>(std::clamp((coordinate - low) * per_m, 0.0, count - 1.0));
}

}  // namespace

NearestStems::NearestStems(std::span<const Eigen::Vector3d> points_m) {
  const std::size_t n = points_m.size();
  if (n == 0) return;
  Eigen::Array2d low = points_m[0].head<2>(), high = low;
  for (const Eigen::Vector3d& p : points_m) {
    low = low.min(p.head<2>().array());
    high = high.max(p.head<2>().array());
  }
  const Eigen::Array2d size = high - low;
  cell_m_ = std::max({std::sqrt(size.prod() * kStemsPerCell / static_cast<double>(n)),
                      size.maxCoeff() / kLongestSide, kLeastCellM});
  per_m_ = 1.0 / cell_m_;
  min_x_ = low.x();
  min_y_ = low.y();
  columns_ = static_cast<int>(size.x() * per_m_) + 1;
  rows_ = static_cast<int>(size.y() * per_m_) + 1;
  sort_into_cells(points_m);
}

void NearestStems::sort_into_cells(std::span<const Eigen::Vector3d> points_m) {
  const std::size_t n = points_m.size();
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  std::vector<std::int32_t> cell(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int column = stem_cell(points_m[i].x(), min_x_, per_m_, columns_);
    const int row = stem_cell(points_m[i].y(), min_y_, per_m_, rows_);
    cell[i] = row * columns_ + column;
    ++first_[static_cast<std::size_t>(cell[i]) + 1];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  x_.resize(n);
  y_.resize(n);
  z_.resize(n);
  index_.resize(n);
  for (std::size_t i = n; i-- > 0;) {  // from the back: rising indices in each cell
    const auto at = static_cast<std::size_t>(--first_[static_cast<std::size_t>(cell[i]) + 1]);
    x_[at] = points_m[i].x();
    y_[at] = points_m[i].y();
    z_[at] = points_m[i].z();
    index_[at] = static_cast<std::int32_t>(i);
  }
  // Each end has been counted down to its cell's beginning.
  first_.erase(first_.begin());
  first_.push_back(static_cast<std::int32_t>(n));
}

template <bool kPlanar>
void NearestStems::search_cells(const Block& block, const Eigen::Vector3d& place,
                                NearestStem& best) const {
  for (int row = block.row0; row <= block.row1; ++row) {
    const auto line = static_cast<std::size_t>(row * columns_);
    const auto end =
        static_cast<std::size_t>(first_[line + static_cast<std::size_t>(block.column1) + 1]);
    auto k = static_cast<std::size_t>(first_[line + static_cast<std::size_t>(block.column0)]);
    for (; k < end; ++k) {
      const double dx = x_[k] - place.x(), dy = y_[k] - place.y();
      double squared = dx * dx + dy * dy;
      if constexpr (!kPlanar) {
        const double dz = z_[k] - place.z();
        squared += dz * dz;
      }
      if (squared > best.squared_m2) continue;
      if (squared == best.squared_m2 && index_[k] >= best.index && best.index >= 0) continue;
      best = {index_[k], squared};
    }
  }
}

NearestStems::Block NearestStems::block_about(double x, double y, double reach_m) const {
  return {stem_cell(x - reach_m, min_x_, per_m_, columns_),
          stem_cell(x + reach_m, min_x_, per_m_, columns_),
          stem_cell(y - reach_m, min_y_, per_m_, rows_),
          stem_cell(y + reach_m, min_y_, per_m_, rows_)};
}

template <bool kPlanar>
NearestStem NearestStems::search(const Eigen::Vector3d& place, NearestStem best) const {
  if (index_.empty()) return best;
  Block seen{0, -1, 0, -1};
  if (best.index < 0) {
    seen = block_about(place.x(), place.y(), cell_m_);
    search_cells<kPlanar>(seen, place, best);
  }
  // Whatever is nearer lies within the best distance, in the plane too.
  const double reach_m = std::sqrt(best.squared_m2) * (1.0 + 1e-12);
  const Block needed = block_about(place.x(), place.y(), reach_m);
  if (!seen.covers(needed)) search_cells<kPlanar>(needed, place, best);
  return best;
}

NearestStem NearestStems::nearest(const Eigen::Vector3d& place_m) const {
  return search<false>(place_m, {-1, std::numeric_limits<double>::infinity()});
}

NearestStem NearestStems::nearest_planar(const Eigen::Vector2d& place_m) const {
  return search<true>({place_m.x(), place_m.y(), 0.0},
                      {-1, std::numeric_limits<double>::infinity()});
}

NearestStem NearestStems::nearest(const Eigen::Vector3d& place_m, NearestStem known) const {
  return search<false>(place_m, known);
}

}  // namespace honka
