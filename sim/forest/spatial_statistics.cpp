#include "sim/forest/spatial_statistics.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/check.h"

namespace honka::sim {
namespace {

using Points = std::vector<Eigen::Vector2d>;

void check(const Points& stems_m, const Eigen::AlignedBox2d& window_m) {
  HONKA_CHECK(stems_m.size() >= 2, "statistics of spacing need two stems");
  HONKA_CHECK(!window_m.isEmpty() && window_m.volume() > 0.0, "the window has an area");
}

/// The stems by rising x, so that near ones are found by a short walk.
Points by_x(Points stems_m) {
  std::sort(stems_m.begin(), stems_m.end(),
            [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return stems_m;
}

double nearest_m(const Points& sorted_m, std::size_t i) {
  double best = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t j) {
    best = std::min(best, (sorted_m[j] - sorted_m[i]).norm());
    return std::abs(sorted_m[j].x() - sorted_m[i].x()) < best;
  };
  for (std::size_t j = i + 1; j < sorted_m.size() && look(j); ++j) {
  }
  for (std::size_t j = i; j > 0 && look(j - 1); --j) {
  }
  return best;
}

}  // namespace

double mean_nearest_neighbour_m(const Points& stems_m, const Eigen::AlignedBox2d& window_m) {
  check(stems_m, window_m);
  const Points sorted_m = by_x(stems_m);
  double sum = 0.0;
  for (std::size_t i = 0; i < sorted_m.size(); ++i) sum += nearest_m(sorted_m, i);
  return sum / static_cast<double>(sorted_m.size());
}

double clark_evans(const Points& stems_m, const Eigen::AlignedBox2d& window_m) {
  const double mean_m = mean_nearest_neighbour_m(stems_m, window_m);
  const auto n = static_cast<double>(stems_m.size());
  const double area = window_m.volume(), perimeter = 2.0 * window_m.sizes().sum();
  // Donnelly1978: the expected mean under complete randomness in a window with a border.
  const double expected =
      0.5 * std::sqrt(area / n) + (0.0514 + 0.041 / std::sqrt(n)) * perimeter / n;
  return mean_m / expected;
}

std::vector<double> pair_correlation(const Points& stems_m, const Eigen::AlignedBox2d& window_m,
                                     const std::vector<double>& radii_m, double half_width_m) {
  check(stems_m, window_m);
  const Points sorted_m = by_x(stems_m);
  const Eigen::Vector2d sides = window_m.sizes();
  const auto n = static_cast<double>(stems_m.size());
  const double density2 = n * (n - 1.0) / (window_m.volume() * window_m.volume());
  std::vector<double> g(radii_m.size(), 0.0);
  const double farthest =
      radii_m.empty() ? 0.0 : *std::max_element(radii_m.begin(), radii_m.end()) + half_width_m;
  for (std::size_t i = 0; i < sorted_m.size(); ++i) {
    for (std::size_t j = i + 1; j < sorted_m.size(); ++j) {
      const Eigen::Vector2d d = (sorted_m[j] - sorted_m[i]).cwiseAbs();
      if (d.x() >= farthest) break;
      const double distance_m = d.norm();
      const double overlap = (sides.x() - d.x()) * (sides.y() - d.y());
      if (overlap <= 0.0) continue;
      for (std::size_t k = 0; k < radii_m.size(); ++k) {
        if (std::abs(distance_m - radii_m[k]) < half_width_m) g[k] += 2.0 / overlap;
      }
    }
  }
  for (std::size_t k = 0; k < radii_m.size(); ++k) {
    const double low = std::max(0.0, radii_m[k] - half_width_m), high = radii_m[k] + half_width_m;
    g[k] /= density2 * kPi * (high * high - low * low);
  }
  return g;
}

}  // namespace honka::sim
