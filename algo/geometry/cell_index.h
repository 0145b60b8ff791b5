#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "algo/types/random.h"

namespace honka {

/// Cells a hair larger or smaller than a bound on distances, so that rounding of a cell number
/// cannot hide a neighbour (wide) or claim one (narrow).
inline constexpr double kWide = 1.0 + 1e-9;
inline constexpr double kNarrow = 1.0 - 1e-9;

/// A lattice of square (Dim 2) or cubic (Dim 3) cells whose 64-bit keys add up: the key of a
/// neighbour is `key(p) + step({dx, dy…})`, for steps of at most kMargin cells.
template <int Dim>
class CellLattice {
 public:
  using Point = Eigen::Matrix<double, Dim, 1>;
  static constexpr int kBits = Dim == 2 ? 32 : 21;
  static constexpr int kMargin = 4;

  /// Covers `points` (finite, any origin) with cells of `side_m`. Ends the program when an axis
  /// would need more than 2^kBits cells.
  CellLattice(std::span<const Point> points, double side_m);
  /// The same from the corners of a box.
  CellLattice(const Point& lowest_m, const Point& highest_m, double side_m);

  [[nodiscard]] std::uint64_t key(const Point& point) const;
  [[nodiscard]] static std::uint64_t step(const std::array<int, Dim>& cells);

 private:
  void check_extent(const Point& highest_m) const;

  Point lowest_m_;
  double cells_per_m_;
};

/// Items grouped by a 64-bit key: cells numbered by first appearance, members in rising order.
/// Open addressing; memory is 8 bytes an item and at most 80 bytes a cell.
class CellIndex {
 public:
  explicit CellIndex(std::span<const std::uint64_t> keys);

  [[nodiscard]] std::size_t cell_count() const { return cell_keys_.size(); }
  [[nodiscard]] std::uint64_t key(std::size_t cell) const { return cell_keys_[cell]; }
  [[nodiscard]] std::uint32_t cell_of(std::size_t item) const { return cell_of_[item]; }
  [[nodiscard]] std::span<const std::uint32_t> members(std::size_t cell) const {
    return std::span(members_).subspan(starts_[cell], starts_[cell + 1] - starts_[cell]);
  }
  [[nodiscard]] std::optional<std::uint32_t> find(std::uint64_t key) const {
    const Slot& slot = slots_[slot_of(key)];
    if (slot.cell == kEmpty) return std::nullopt;
    return slot.cell;
  }

 private:
  static constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t cell = kEmpty;
  };
  /// Where the key is, or the empty slot where it would go.
  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = mix64(key) & mask;
    while (slots_[slot].cell != kEmpty && slots_[slot].key != key) slot = (slot + 1) & mask;
    return slot;
  }
  void grow();

  std::vector<std::uint64_t> cell_keys_;
  std::vector<Slot> slots_;  ///< a power of two, at most half full
  std::vector<std::uint32_t> cell_of_, starts_, members_;
};

extern template class CellLattice<2>;
extern template class CellLattice<3>;

}  // namespace honka
