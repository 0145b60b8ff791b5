#include "algo/localize/consensus/stem_grid.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace honka {
namespace {

bool stands_before(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
}

}  // namespace

StemGrid::StemGrid(std::vector<Eigen::Vector2d> stems_m) : stems_(std::move(stems_m)) {
  std::sort(stems_.begin(), stems_.end(), stands_before);
  stems_.erase(std::unique(stems_.begin(), stems_.end()), stems_.end());
  choose_torus();
  sort_by_slot();
  measure_area();
}

void StemGrid::choose_torus() {
  constexpr std::size_t kSlotsPerStem = 16;  // a stand has three cells a stem
  Eigen::Vector2d low = stems_.empty() ? Eigen::Vector2d(0, 0) : stems_[0];
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& p : stems_) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const auto bits_for = [](double extent_m) {
    const double cells = std::min(extent_m / kCell_m + 2.0, 1e9);
    constexpr int kLeastBits = 5;  // wider than any search for neighbours
    return static_cast<unsigned>(
        std::max(kLeastBits, static_cast<int>(std::bit_width(static_cast<std::uint64_t>(cells)))));
  };
  bits_x_ = bits_for(high.x() - low.x());
  unsigned bits_y = bits_for(high.y() - low.y());
  while ((std::size_t{1} << (bits_x_ + bits_y)) > kSlotsPerStem * (stems_.size() + 64)) {
    --(bits_x_ > bits_y ? bits_x_ : bits_y);
  }
  mask_x_ = (std::size_t{1} << bits_x_) - 1;
  mask_y_ = (std::size_t{1} << bits_y) - 1;
}

void StemGrid::sort_by_slot() {
  const auto slot_of = [&](const Eigen::Vector2d& p) {
    return slot(cell_of(p.x()), cell_of(p.y()));
  };
  starts_.assign((mask_x_ + 1) * (mask_y_ + 1) + 1, 0);
  for (const Eigen::Vector2d& p : stems_) ++starts_[slot_of(p) + 1];
  for (std::size_t s = 1; s < starts_.size(); ++s) starts_[s] += starts_[s - 1];
  std::vector<Eigen::Vector2d> sorted(stems_.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (const Eigen::Vector2d& p : stems_) sorted[next[slot_of(p)]++] = p;
  stems_ = std::move(sorted);
}

void StemGrid::measure_area() {
  constexpr std::int64_t kBlock = 4;
  constexpr double kBlock_m2 = kBlock * kCell_m * kBlock * kCell_m;
  std::vector<std::pair<std::int64_t, std::int64_t>> blocks;
  blocks.reserve(stems_.size());
  for (const Eigen::Vector2d& p : stems_) {
    blocks.emplace_back(cell_of(p.x()) / kBlock, cell_of(p.y()) / kBlock);
  }
  std::sort(blocks.begin(), blocks.end());
  const auto end = std::unique(blocks.begin(), blocks.end());
  area_m2_ = std::max(1.0, kBlock_m2 * static_cast<double>(end - blocks.begin()));
}

void StemGrid::nearest_others(std::uint32_t stem, std::size_t count, double reach_m,
                              std::vector<std::pair<double, std::uint32_t>>& found) const {
  found.clear();
  const Eigen::Vector2d& centre = stems_[stem];
  const std::int64_t cx = cell_of(centre.x());
  const std::int64_t cy = cell_of(centre.y());
  const auto visit = [&](std::int64_t x, std::int64_t y) {
    const std::size_t c = slot(x, y);
    for (std::uint32_t i = starts_[c]; i < starts_[c + 1]; ++i) {
      const std::pair entry((stems_[i] - centre).squaredNorm(), i);
      if (i == stem || entry.first > reach_m * reach_m) continue;
      if (found.size() == count) {
        if (entry >= found.back()) continue;
        found.pop_back();
      }
      found.insert(std::upper_bound(found.begin(), found.end(), entry), entry);
    }
  };
  // Rings of cells outwards, until what is farther cannot be nearer.
  const auto rings =
      std::min<std::int64_t>(static_cast<std::int64_t>(reach_m / kCell_m) + 1,
                             static_cast<std::int64_t>(std::min(mask_x_, mask_y_)) / 2);
  for (std::int64_t ring = 0; ring <= rings; ++ring) {
    const double cleared_m = static_cast<double>(ring - 1) * kCell_m;
    if (found.size() == count && ring > 0 && found.back().first <= cleared_m * cleared_m) return;
    for (std::int64_t y = -ring; y <= ring; ++y) {
      const std::int64_t stride = std::abs(y) == ring ? 1 : std::max<std::int64_t>(2 * ring, 1);
      for (std::int64_t x = -ring; x <= ring; x += stride) visit(cx + x, cy + y);
    }
  }
}

}  // namespace honka
