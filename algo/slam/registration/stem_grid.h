#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace honka {

/// Exact nearest neighbours among few points in the plane, for very many queries: each cell of a
/// square grid holds the points that can be nearest to any place in the cell (one to three, as a
/// rule). Queries beyond the grid are answered by looking at every point.
class StemGrid {
 public:
  /// Points in metres, finite; at least one. The grid reaches `margin_m` beyond them.
  StemGrid(std::span<const Eigen::Vector2d> points_m, double margin_m);

  /// Squared distance of each place to the nearest point, m². All three of one length.
  void squared_distances(std::span<const double> x_m, std::span<const double> y_m,
                         std::span<double> squared_m2) const;
  /// Index of the nearest point; the lowest of equals.
  [[nodiscard]] std::uint32_t nearest(double x_m, double y_m) const;
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points_m() const { return points_; }

 private:
  /// The first four candidates of a cell side by side (fewer: the first again), so that most
  /// queries are four distances without a branch.
  struct Cell {
    std::array<double, 4> x{}, y{};
    std::uint32_t begin = 0, end = 0;  ///< of its candidates
  };
  [[nodiscard]] const Cell& cell_of(double x_m, double y_m) const;
  void fill_cells();
  [[nodiscard]] Cell make_cell(const std::vector<std::uint32_t>& candidates);

  std::vector<Eigen::Vector2d> points_;
  Eigen::Vector2d low_m_ = Eigen::Vector2d::Zero();
  double per_cell_ = 1.0;                ///< cells a metre
  std::int64_t columns_ = 0, rows_ = 0;  ///< with a ring of cells for all that lies beyond
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> candidates_;  ///< indices of points, cell by cell, each rising
};

}  // namespace honka
