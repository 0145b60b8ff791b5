#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

namespace honka {

/// The stems of a map in square cells, stored cell by cell, for "the nearest
/// stem within a gate".
///
/// Cells lie on a torus of 2^a × 2^b: their numbers wrap around, so that a
/// stray stem far away costs nothing; distances tell stems of one cell apart.
/// Coordinates are relative to a centre.
class StemGrid {
 public:
  /// Side of a cell; a gate is at most half of it, so that it touches 2 × 2
  /// cells.
  static constexpr double kCell_m = 3.0;
  static constexpr double kWidestGate_m = 0.5 * kCell_m;

  struct Partner {
    std::int32_t stem = -1;  ///< −1: no stem within the gate
    double squared_m2 = 0.0;
  };

  StemGrid() = default;
  /// Takes finite places in any order and stores each distinct one, in an order
  /// of its own.
  explicit StemGrid(std::vector<Eigen::Vector2d> stems_m);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& stems() const { return stems_; }
  /// Ground on which the stems stand: blocks of 12 m that hold one.
  [[nodiscard]] double area_m2() const { return area_m2_; }
  [[nodiscard]] double density_per_m2() const {
    return static_cast<double>(stems_.size()) / area_m2_;
  }

  /// The nearest stem within `gate_m` ≤ kWidestGate_m.
  [[nodiscard]] Partner nearest(const Eigen::Vector2d& place_m, double gate_m) const {
    Partner best{-1, gate_m * gate_m};
    const std::int64_t x0 = cell_of(place_m.x() - gate_m);
    const std::int64_t x1 = cell_of(place_m.x() + gate_m);
    const std::int64_t y1 = cell_of(place_m.y() + gate_m);
    for (std::int64_t y = cell_of(place_m.y() - gate_m); y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        const std::size_t c = slot(x, y);
        for (std::uint32_t i = starts_[c]; i < starts_[c + 1]; ++i) {
          const double squared = (stems_[i] - place_m).squaredNorm();
          if (squared < best.squared_m2) best = {static_cast<std::int32_t>(i), squared};
        }
      }
    }
    return best;
  }

  /// Calls `visit` with every stem within `reach_m` of a place, cell by cell.
  template <typename Visit>
  void within(const Eigen::Vector2d& place_m, double reach_m, const Visit& visit) const {
    const std::int64_t x0 = cell_of(place_m.x() - reach_m);
    const std::int64_t x1 = cell_of(place_m.x() + reach_m);
    const std::int64_t y1 = cell_of(place_m.y() + reach_m);
    for (std::int64_t y = cell_of(place_m.y() - reach_m); y <= y1; ++y) {
      for (std::int64_t x = x0; x <= x1; ++x) {
        const std::size_t c = slot(x, y);
        for (std::uint32_t i = starts_[c]; i < starts_[c + 1]; ++i) {
          if ((stems_[i] - place_m).squaredNorm() < reach_m * reach_m) visit(i);
        }
      }
    }
  }

  /// The `count` nearest other stems within `reach_m`, by distance, then by
  /// place in the order.
  void nearest_others(std::uint32_t stem, std::size_t count, double reach_m,
                      std::vector<std::pair<double, std::uint32_t>>& found) const;

 private:
  /// Rounds down without a call: 2^40 cells are beyond every map, and a
  /// multiple of the torus.
  [[nodiscard]] static std::int64_t cell_of(double coordinate_m) {
    return static_cast<std::int64_t>(coordinate_m * (1.0 / kCell_m) + 0x1p40);
  }
  /// Cells of a block of 8 × 8 lie side by side, so that the stems around a place share few lines
  /// of memory.
  [[nodiscard]] std::size_t slot(std::int64_t x, std::int64_t y) const {
    const std::size_t column = static_cast<std::size_t>(x) & mask_x_;
    const std::size_t row = static_cast<std::size_t>(y) & mask_y_;
    return ((row >> 3U) << (bits_x_ - 3U) | column >> 3U) << 6U | (row & 7U) << 3U | (column & 7U);
  }
  void choose_torus();
  void sort_by_slot();
  void measure_area();

  std::vector<Eigen::Vector2d> stems_;
  std::vector<std::uint32_t> starts_;  ///< of each slot in stems_
  unsigned bits_x_ = 0;
  std::size_t mask_x_ = 0, mask_y_ = 0;
  double area_m2_ = 1.0;
};

}  // namespace honka
