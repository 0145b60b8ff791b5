#pragma once

#include <Eigen/Core>
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

  /// Squared distance to the nearest point, m².
  [[nodiscard]] double squared_distance(double x_m, double y_m) const;
  /// Index of the nearest point; the lowest of equals.
  [[nodiscard]] std::uint32_t nearest(double x_m, double y_m) const;
  [[nodiscard]] const std::vector<Eigen::Vector2d>& points_m() const { return points_; }

 private:
  struct Candidate {
    double x = 0.0, y = 0.0;
    std::uint32_t index = 0;
  };
  [[nodiscard]] std::span<const Candidate> candidates(double x_m, double y_m) const;
  void fill_cells();

  std::vector<Eigen::Vector2d> points_;
  Eigen::Vector2d low_m_ = Eigen::Vector2d::Zero();
  double per_cell_ = 1.0;  ///< cells a metre
  std::int64_t columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_;  ///< of each cell, into candidates_; one more at the end
  std::vector<Candidate> candidates_;
  std::vector<Candidate> all_;
};

}  // namespace honka
