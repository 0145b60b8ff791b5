#include "algo/geometry/cell_index.h"

#include <cmath>

#include "algo/types/check.h"

namespace honka {
namespace {

constexpr std::size_t kFirstCellSlots = 1024;

template <class Point>
Point lowest_of(std::span<const Point> points) {
  if (points.empty()) return Point::Zero();
  Point lowest = points.front();
  for (const Point& p : points) lowest = lowest.cwiseMin(p);
  return lowest;
}

template <class Point>
Point highest_of(std::span<const Point> points) {
  if (points.empty()) return Point::Zero();
  Point highest = points.front();
  for (const Point& p : points) highest = highest.cwiseMax(p);
  return highest;
}

}  // namespace

template <int Dim>
CellLattice<Dim>::CellLattice(std::span<const Point> points, double side_m)
    : CellLattice(lowest_of(points), highest_of(points), side_m) {}

template <int Dim>
CellLattice<Dim>::CellLattice(const Point& lowest_m, const Point& highest_m, double side_m)
    : lowest_m_(lowest_m), cells_per_m_(1.0 / side_m) {
  HONKA_CHECK(side_m > 0.0, "a cell needs a side");
  check_extent(highest_m);
}

template <int Dim>
void CellLattice<Dim>::check_extent(const Point& highest_m) const {
  const double cells = (highest_m - lowest_m_).maxCoeff() * cells_per_m_ + 2.0 * kMargin + 1.0;
  HONKA_CHECK(cells < std::ldexp(1.0, kBits), "points span too many cells for one key");
}

template <int Dim>
std::uint64_t CellLattice<Dim>::key(const Point& point) const {
  std::uint64_t key = 0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double cell = (point[axis] - lowest_m_[axis]) * cells_per_m_;  // never negative
    key += (static_cast<std::uint64_t>(cell) + kMargin) << (axis * kBits);
  }
  return key;
}

template <int Dim>
std::uint64_t CellLattice<Dim>::step(const std::array<int, Dim>& cells) {
  std::uint64_t sum = 0;  // wraps on purpose: adding it to a key subtracts negative steps
  for (int axis = 0; axis < Dim; ++axis) {
    sum += static_cast<std::uint64_t>(static_cast<std::int64_t>(cells[axis])) << (axis * kBits);
  }
  return sum;
}

CellIndex::CellIndex(std::span<const std::uint64_t> keys) : slots_(kFirstCellSlots) {
  HONKA_CHECK(keys.size() < kEmpty, "too many items for 32-bit indices");
  cell_of_.resize(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    Slot& slot = slots_[slot_of(keys[i])];
    const bool fresh = slot.cell == kEmpty;
    if (fresh) {
      slot = {keys[i], static_cast<std::uint32_t>(cell_keys_.size())};
      cell_keys_.push_back(keys[i]);
    }
    cell_of_[i] = slot.cell;
    if (fresh && 2 * cell_keys_.size() > slots_.size()) grow();
  }
  starts_.assign(cell_keys_.size() + 1, 0);
  for (const std::uint32_t cell : cell_of_) ++starts_[cell + 1];
  for (std::size_t c = 0; c < cell_keys_.size(); ++c) starts_[c + 1] += starts_[c];
  members_.resize(keys.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  for (std::uint32_t i = 0; i < keys.size(); ++i) members_[next[cell_of_[i]]++] = i;
}

void CellIndex::grow() {
  slots_.assign(2 * slots_.size(), Slot{});
  for (std::uint32_t c = 0; c < cell_keys_.size(); ++c) {
    slots_[slot_of(cell_keys_[c])] = {cell_keys_[c], c};
  }
}

template class CellLattice<2>;
template class CellLattice<3>;

}  // namespace honka
