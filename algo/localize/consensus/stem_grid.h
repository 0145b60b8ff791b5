#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace honka {

/// The stems of a map in square cells, stored cell by cell, for "the nearest stem within a gate".
///
/// Cells lie on a torus of 2^a × 2^b: their numbers wrap around, so that a stray stem far away
/// costs nothing; distances tell stems of one cell apart. Coordinates are relative to the map's
/// centre.
class StemGrid {
 public:
  /// Side of a cell; a gate is at most half of it, so that it touches 2 × 2 cells.
  static constexpr double kCell_m = 3.0;
  static constexpr double kWidestGate_m = 0.5 * kCell_m;

  struct Partner {
    std::int32_t stem = -1;  ///< −1: no stem within the gate
    double squared_m2 = 0.0;
  };

  StemGrid() = default;
  /// Takes distinct, finite places in any order; they are stored in an order of their own.
  explicit StemGrid(std::vector<Eigen::Vector2d> stems_m);

  [[nodiscard]] const std::vector<Eigen::Vector2d>& stems() const { return stems_; }
  /// Stems per m² of the cells around those that hold stems.
  [[nodiscard]] double density_per_m2() const { return density_per_m2_; }
  /// Ground on which stems stand, m².
  [[nodiscard]] double area_m2() const {
    return static_cast<double>(stems_.size()) / density_per_m2_;
  }

  /// The nearest stem within `gate_m` ≤ kWidestGate_m.
  [[nodiscard]] Partner nearest(const Eigen::Vector2d& place_m, double gate_m) const;
  /// Calls f(stem) for all stems within the radius, and maybe for others.
  template <class F>
  void for_each_around(const Eigen::Vector2d& place_m, double radius_m, F&& f) const;

 private:
  [[nodiscard]] std::size_t cell(std::int64_t ix, std::int64_t iy) const {
    return (static_cast<std::size_t>(iy) & mask_y_) << bits_x_ |
           (static_cast<std::size_t>(ix) & mask_x_);
  }

  std::vector<Eigen::Vector2d> stems_;
  std::vector<std::uint32_t> starts_;
  unsigned bits_x_ = 0;
  std::size_t mask_x_ = 0, mask_y_ = 0;
  double density_per_m2_ = 0.0;
};

}  // namespace honka
