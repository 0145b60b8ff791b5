#include "algo/slam/registration/stem_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "algo/types/check.h"

namespace honka {
namespace {

constexpr double kStemCell_m = 1.0;         // a fifth of the distance between stems or so
constexpr double kMostStemCells = 40000.0;  // a wider grid gets wider cells
constexpr std::int64_t kStemBlock = 4;      // cells a side that share a first choice of points

/// Of `from`, the points that can be nearest to a place in the square. Of two points, the one
/// nearer to the middle is nearer everywhere unless their bisector crosses the square:
/// |x − p|² − |x − q|² is linear in x.
void keep_nearest_of_square(const std::vector<Eigen::Vector2d>& points,
                            const std::vector<std::uint32_t>& from, const Eigen::Vector2d& middle,
                            double half_m, std::vector<std::uint32_t>& kept) {
  kept.clear();
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t nearest = 0;
  for (const std::uint32_t i : from) {
    const double d = (points[i] - middle).squaredNorm();
    if (d < best) {
      best = d;
      nearest = i;
    }
  }
  constexpr double kRounding = 1e-9;
  for (const std::uint32_t i : from) {
    const double behind = (points[i] - middle).squaredNorm() - best;
    const double swing = 2.0 * half_m * (points[i] - points[nearest]).lpNorm<1>();
    if (behind <= swing + kRounding * (1.0 + best)) kept.push_back(i);
  }
}

}  // namespace

StemGrid::StemGrid(std::span<const Eigen::Vector2d> points_m, double margin_m)
    : points_(points_m.begin(), points_m.end()) {
  HONKA_CHECK(!points_.empty(), "a grid of no stems");
  low_m_ = points_.front();
  Eigen::Vector2d high = points_.front();
  for (const Eigen::Vector2d& p : points_) {
    low_m_ = low_m_.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d size = (high - low_m_).array() + 2.0 * margin_m;
  const double side = std::max(
      {kStemCell_m, std::sqrt(size.prod() / kMostStemCells), size.maxCoeff() / kMostStemCells});
  low_m_.array() -= margin_m + side;  // the ring
  per_cell_ = 1.0 / side;
  columns_ = static_cast<std::int64_t>(size.x() * per_cell_) + 3;
  rows_ = static_cast<std::int64_t>(size.y() * per_cell_) + 3;
  fill_cells();
}

const StemGrid::Cell& StemGrid::cell_of(double x_m, double y_m) const {
  const double column = (x_m - low_m_.x()) * per_cell_;
  const double row = (y_m - low_m_.y()) * per_cell_;
  const double last_column = static_cast<double>(columns_ - 1);
  const double last_row = static_cast<double>(rows_ - 1);
  const auto c = static_cast<std::int64_t>(std::min(std::max(column, 0.0), last_column));
  const auto r = static_cast<std::int64_t>(std::min(std::max(row, 0.0), last_row));
  return cells_[static_cast<std::size_t>(r * columns_ + c)];
}

void StemGrid::squared_distances(std::span<const double> x_m, std::span<const double> y_m,
                                 std::span<double> squared_m2) const {
  for (std::size_t i = 0; i < x_m.size(); ++i) {
    const Cell& cell = cell_of(x_m[i], y_m[i]);
    std::array<double, 4> d;
    for (std::size_t k = 0; k < 4; ++k) {
      const double dx = cell.x[k] - x_m[i];
      const double dy = cell.y[k] - y_m[i];
      d[k] = dx * dx + dy * dy;
    }
    double best = std::min(std::min(d[0], d[1]), std::min(d[2], d[3]));
    for (std::uint32_t k = cell.begin + 4; k < cell.end; ++k) {
      const Eigen::Vector2d& p = points_[candidates_[k]];
      const double dx = p.x() - x_m[i];
      const double dy = p.y() - y_m[i];
      best = std::min(best, dx * dx + dy * dy);
    }
    squared_m2[i] = best;
  }
}

std::uint32_t StemGrid::nearest(double x_m, double y_m) const {
  const Cell& cell = cell_of(x_m, y_m);
  double best = std::numeric_limits<double>::infinity();
  std::uint32_t index = 0;
  for (std::uint32_t k = cell.begin; k < cell.end; ++k) {
    const double d = (points_[candidates_[k]] - Eigen::Vector2d(x_m, y_m)).squaredNorm();
    if (d < best) {
      best = d;
      index = candidates_[k];
    }
  }
  return index;
}

StemGrid::Cell StemGrid::make_cell(const std::vector<std::uint32_t>& candidates) {
  Cell cell;
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& p = points_[candidates[k < candidates.size() ? k : 0]];
    cell.x[k] = p.x();
    cell.y[k] = p.y();
  }
  cell.begin = static_cast<std::uint32_t>(candidates_.size());
  candidates_.insert(candidates_.end(), candidates.begin(), candidates.end());
  cell.end = static_cast<std::uint32_t>(candidates_.size());
  return cell;
}

void StemGrid::fill_cells() {
  std::vector<std::uint32_t> all(points_.size());
  std::iota(all.begin(), all.end(), 0U);
  cells_.assign(static_cast<std::size_t>(columns_ * rows_), make_cell(all));
  std::vector<std::uint32_t> block, kept;
  const double side = 1.0 / per_cell_;
  for (std::int64_t row0 = 1; row0 + 1 < rows_; row0 += kStemBlock) {
    for (std::int64_t column0 = 1; column0 + 1 < columns_; column0 += kStemBlock) {
      const Eigen::Vector2d corner = low_m_ + side * Eigen::Vector2d(column0, row0);
      const double half = 0.5 * side * static_cast<double>(kStemBlock);
      keep_nearest_of_square(points_, all, corner.array() + half, half, block);
      for (std::int64_t row = row0; row < std::min(row0 + kStemBlock, rows_ - 1); ++row) {
        for (std::int64_t c = column0; c < std::min(column0 + kStemBlock, columns_ - 1); ++c) {
          const Eigen::Vector2d middle = low_m_ + side * Eigen::Vector2d(c + 0.5, row + 0.5);
          keep_nearest_of_square(points_, block, middle, 0.5 * side, kept);
          cells_[static_cast<std::size_t>(row * columns_ + c)] = make_cell(kept);
        }
      }
    }
  }
}

}  // namespace honka
