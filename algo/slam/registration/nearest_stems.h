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
class NearestStems {
 public:
  NearestStems() = default;
  /// `points_m` must be finite; they are copied.
  explicit NearestStems(std::span<const Eigen::Vector3d> points_m);

  /// Nearest in space, and in the plane (x, y).
  [[nodiscard]] NearestStem nearest(const Eigen::Vector3d& place_m) const;
  [[nodiscard]] NearestStem nearest_planar(const Eigen::Vector2d& place_m) const;

  [[nodiscard]] std::size_t size() const { return index_.size(); }

 private:
  template <bool kPlanar>
  [[nodiscard]] NearestStem search(double x, double y, double z) const;

  double min_x_ = 0.0, min_y_ = 0.0, cell_m_ = 1.0, per_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<std::int32_t> first_;  ///< of each cell, row by row, and the end
  std::vector<double> x_, y_, z_;    ///< in the order of the cells
  std::vector<std::int32_t> index_;
};

}  // namespace honka
