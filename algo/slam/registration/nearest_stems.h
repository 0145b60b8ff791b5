#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace honka {

/// The stem nearest to a place.
struct NearestStem {
  std::int32_t index = -1;  ///< in the input; −1 where there are no stems
  double squared_m2 = 0.0;  ///< squared distance; infinite where there are no stems
};

/// Exact nearest neighbours among some hundred sparse points, made for clouds that live for one
/// registration: building costs a few microseconds. Of two equally near, the lower index.
/// Places asked for must be finite.
class NearestStems {
 public:
  NearestStems() = default;
  /// `points_m` must be finite; they are copied.
  explicit NearestStems(std::span<const Eigen::Vector3d> points_m);

  /// Nearest in space, and in the plane (x, y).
  [[nodiscard]] NearestStem nearest(const Eigen::Vector3d& place_m) const;
  [[nodiscard]] NearestStem nearest_planar(const Eigen::Vector2d& place_m) const;

  /// The same where some stem of the cloud is known to be near: the nearer, the faster. `known`
  /// holds its index and its squared distance from the place.
  [[nodiscard]] NearestStem nearest(const Eigen::Vector3d& place_m, NearestStem known) const;

  [[nodiscard]] std::size_t size() const { return index_.size(); }

 private:
  /// Cells from the first to the last column and row, both included.
  struct Block {
    int column0, column1, row0, row1;
    [[nodiscard]] bool covers(const Block& b) const {
      return column0 <= b.column0 && b.column1 <= column1 && row0 <= b.row0 && b.row1 <= row1;
    }
  };
  void sort_into_cells(std::span<const Eigen::Vector3d> points_m);
  [[nodiscard]] Block block_about(double x, double y, double reach_m) const;
  template <bool kPlanar>
  void search_cells(const Block& block, const Eigen::Vector3d& place, NearestStem& best) const;
  template <bool kPlanar>
  [[nodiscard]] NearestStem search(const Eigen::Vector3d& place, NearestStem best) const;

  double min_x_ = 0.0, min_y_ = 0.0, cell_m_ = 1.0, per_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> first_;  ///< of each cell, row by row, and the end
  std::vector<double> x_, y_, z_;    ///< in the order of the cells
  std::vector<std::int32_t> index_;
};

}  // namespace honka
