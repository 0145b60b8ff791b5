#include "eval/report/plot_points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka::eval {

std::vector<Eigen::Vector3d> thinned(const std::vector<Eigen::Vector3d>& points,
                                     std::size_t limit) {
  if (points.size() <= limit) return points;
  // Multiples of the golden ratio modulo the size fall evenly and out of step with any pattern.
  constexpr double kGolden = 0.6180339887498949;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < limit; ++i) {
    const double turn = static_cast<double>(i) * kGolden;
    const auto index =
        static_cast<std::size_t>((turn - std::floor(turn)) * static_cast<double>(points.size()));
    chosen.push_back(std::min(index, points.size() - 1));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  std::vector<Eigen::Vector3d> kept;
  for (const std::size_t i : chosen) kept.push_back(points[i]);
  return kept;
}

std::vector<std::vector<double>> columns_of(const std::vector<Eigen::Vector3d>& points) {
  std::vector<std::vector<double>> columns(3);
  for (const auto& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      columns[static_cast<std::size_t>(axis)].push_back(point[axis]);
    }
  }
  return columns;
}

std::pair<double, double> quantile_range(std::vector<double> values, double low, double high) {
  if (values.empty()) return {0.0, 1.0};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {at(low), at(high)};
}

Ellipse two_sd_ellipse(const std::vector<Eigen::Vector2d>& points) {
  Ellipse ellipse;
  if (points.size() < 2) return ellipse;
  for (const auto& point : points) ellipse.mean += point / static_cast<double>(points.size());
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const auto& point : points) {
    covariance += (point - ellipse.mean) * (point - ellipse.mean).transpose() /
                  static_cast<double>(points.size() - 1);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  ellipse.half_axes =
      solver.eigenvectors() * (2.0 * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt()).asDiagonal();
  return ellipse;
}

std::vector<Eigen::Vector2d> outline(const Ellipse& ellipse, int n) {
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= n; ++i) {
    const double angle = 2.0 * kPi * i / n;
    points.push_back(ellipse.mean +
                     ellipse.half_axes * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace honka::eval
