#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

namespace honka::eval {

/// At most `limit` of the points: every k-th in a scrambled order, so that no pattern of the scan
/// or of a sorted cloud shows. The same points for the same input.
[[nodiscard]] std::vector<Eigen::Vector3d> thinned(const std::vector<Eigen::Vector3d>& points,
                                                   std::size_t limit);

/// Columns x, y, z of points, for Figure::data.
[[nodiscard]] std::vector<std::vector<double>> columns_of(
    const std::vector<Eigen::Vector3d>& points);

/// The values at two shares of the sorted list (0.01 and 0.99: a range without outliers); {0, 1}
/// for an empty list.
[[nodiscard]] std::pair<double, double> quantile_range(std::vector<double> values, double low,
                                                       double high);

/// Mean and half axes of the 2 s.d. ellipse of points in the plane.
struct Ellipse {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d half_axes = Eigen::Matrix2d::Zero();  ///< columns: direction times 2 s.d.
};
[[nodiscard]] Ellipse two_sd_ellipse(const std::vector<Eigen::Vector2d>& points);

/// `n` + 1 points around an ellipse, closed.
[[nodiscard]] std::vector<Eigen::Vector2d> outline(const Ellipse& ellipse, int n = 72);

}  // namespace honka::eval
