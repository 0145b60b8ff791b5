#include "algo/odometry/loam/deskew.h"

#include <algorithm>
#include <array>

namespace honka {
namespace {

constexpr int kDeskewSteps = 32;

using DeskewMatrix = Eigen::Matrix<double, 3, 4>;

}  // namespace

std::vector<Eigen::Vector3d> deskewed(const std::vector<LoamFeature>& features,
                                      const Twist& twist_per_sweep) {
  // Exact at 33 knots, matrices blended between: off by Δθ²/8 of the range, Δθ the turn between
  // two knots; at 1 rad/s 1.2e-6, 0.05 mm at 40 m.
  std::array<DeskewMatrix, kDeskewSteps + 1> knots;
  for (int k = 0; k <= kDeskewSteps; ++k) {
    const double share = static_cast<double>(k) / kDeskewSteps;
    knots[static_cast<std::size_t>(k)] =
        se3_exp((share - 0.5) * twist_per_sweep).matrix().topRows<3>();
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(features.size());
  for (const LoamFeature& f : features) {
    const double at = f.share * kDeskewSteps;
    const int k = std::clamp(static_cast<int>(at), 0, kDeskewSteps - 1);
    const auto i = static_cast<std::size_t>(k);
    const DeskewMatrix m = (1.0 - (at - k)) * knots[i] + (at - k) * knots[i + 1];
    points.push_back(m.leftCols<3>() * f.point_m + m.col(3));
  }
  return points;
}

}  // namespace honka
