#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace honka {

/// Height of the ground estimated from a levelled cloud itself.
///
/// Cells of 1 m keep their lowest point. A cell is ground when no cell within 10 m undercuts it by
/// more than 0.3 m and a slope of 20 % against the plane of the ground; cells without ground take
/// the harmonic interpolation of those around; then one 3 × 3 mean. Bilinear between cell centres.
class GroundGrid {
 public:
  explicit GroundGrid(std::span<const Eigen::Vector3d> points_m);
  [[nodiscard]] double height_m(const Eigen::Vector2d& position_m) const;

 private:
  [[nodiscard]] std::size_t at(int ix, int iy) const;
  void keep_lowest(std::span<const Eigen::Vector3d> points_m);
  [[nodiscard]] std::vector<bool> ground_cells() const;
  void fill(const std::vector<bool>& known);
  void smooth();

  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();  ///< centre of cell (0, 0)
  int nx_ = 0, ny_ = 0;
  std::vector<double> heights_m_;
};

}  // namespace honka
