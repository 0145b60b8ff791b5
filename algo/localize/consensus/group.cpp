#include "algo/localize/consensus/group.h"

#include <algorithm>
#include <cmath>

namespace honka {
namespace {

/// Rises with the direction of v, without a call of atan2.
double direction_rank(const Eigen::Vector2d& v) {
  const double length = std::abs(v.x()) + std::abs(v.y());
  const double p = length > 0.0 ? v.x() / length : 0.0;
  return v.y() < 0.0 ? p - 1.0 : 1.0 - p;
}

}  // namespace

void sort_around(std::span<const Eigen::Vector2d> stems_m, std::uint32_t base,
                 std::span<std::uint32_t> others) {
  std::sort(others.begin(), others.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(direction_rank(stems_m[a] - stems_m[base]), a) <
           std::pair(direction_rank(stems_m[b] - stems_m[base]), b);
  });
}

}  // namespace honka
