#include "algo/slam/map_quality/blur.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace honka {
namespace {

/// Grids up to this many points are counted in a bitmap (16 MB), larger ones by sorting.
constexpr double kLargestBitmap = 134217728.0;

bool is_finite_point(const Eigen::Vector3d& p) {
  return 0.0 * p.x() + 0.0 * p.y() + 0.0 * p.z() == 0.0;
}

/// Whole-numbered corners of the part of the grid that the map reaches.
struct GridExtent {
  std::array<double, 3> low{}, high{};
  bool empty = true;

  [[nodiscard]] double points() const {
    double count = empty ? 0.0 : 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) count *= high[axis] - low[axis] + 1.0;
    return count;
  }
};

double rounded(double coordinate_m, double spacing_m) {
  return std::floor(coordinate_m / spacing_m + 0.5);
}

GridExtent extent_of(std::span<const Eigen::Vector3d> map_m, double spacing_m, int dimensions) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  for (const Eigen::Vector3d& p : map_m) {
    if (!is_finite_point(p)) continue;
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  GridExtent extent;
  extent.empty = !(low.x() <= high.x());
  if (extent.empty) return extent;
  for (int axis = 0; axis < dimensions; ++axis) {
    extent.low[static_cast<std::size_t>(axis)] = rounded(low[axis], spacing_m);
    extent.high[static_cast<std::size_t>(axis)] = rounded(high[axis], spacing_m);
  }
  return extent;
}

std::int64_t count_in_bitmap(std::span<const Eigen::Vector3d> map_m, double spacing_m,
                             int dimensions, const GridExtent& extent) {
  std::array<std::size_t, 3> stride{1, 1, 1};
  for (std::size_t axis = 1; axis < 3; ++axis) {
    stride[axis] = stride[axis - 1] *
                   static_cast<std::size_t>(extent.high[axis - 1] - extent.low[axis - 1] + 1.0);
  }
  std::vector<std::uint64_t> bits(static_cast<std::size_t>(extent.points()) / 64 + 1, 0);
  for (const Eigen::Vector3d& p : map_m) {
    if (!is_finite_point(p)) continue;
    std::size_t index = 0;
    for (int a = 0; a < dimensions; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      // Not below zero, so that cutting off the fraction is rounding down.
      const double from_low = p[a] / spacing_m + 0.5 - extent.low[axis];
      index += stride[axis] * static_cast<std::size_t>(from_low);
    }
    bits[index / 64] |= std::uint64_t{1} << (index % 64);
  }
  std::int64_t count = 0;
  for (const std::uint64_t word : bits) count += std::popcount(word);
  return count;
}

std::int64_t count_by_sorting(std::span<const Eigen::Vector3d> map_m, double spacing_m,
                              int dimensions) {
  std::vector<std::array<double, 3>> grid_points;
  for (const Eigen::Vector3d& p : map_m) {
    if (!is_finite_point(p)) continue;
    auto& grid_point = grid_points.emplace_back();
    for (int axis = 0; axis < dimensions; ++axis)
      grid_point[static_cast<std::size_t>(axis)] = rounded(p[axis], spacing_m);
  }
  std::sort(grid_points.begin(), grid_points.end());
  return std::unique(grid_points.begin(), grid_points.end()) - grid_points.begin();
}

}  // namespace

void describe(SettingsVisitor& v, BlurSettings& s) {
  v.field({"fine_m", "m", "spacing of the grid that sees a tree's registrations",
           "Nevalainen2021 §2.5, ε1"},
          s.fine_m, Range{0.001, 100.0});
  v.field(
      {"coarse_m", "m", "spacing of the grid that sees the map's area", "Nevalainen2021 §2.5, ε2"},
      s.coarse_m, Range{0.001, 1000.0});
  v.field({"spatial", "", "count in space with cubed spacings, not in the plane",
           "Nevalainen2021 §4: by a change of the power of ε"},
          s.spatial);
}

std::int64_t occupied_grid_points(std::span<const Eigen::Vector3d> map_m, double spacing_m,
                                  bool spatial) {
  const int dimensions = spatial ? 3 : 2;
  const GridExtent extent = extent_of(map_m, spacing_m, dimensions);
  if (extent.empty) return 0;
  if (extent.points() <= kLargestBitmap) {
    return count_in_bitmap(map_m, spacing_m, dimensions, extent);
  }
  return count_by_sorting(map_m, spacing_m, dimensions);
}

double blur(std::span<const Eigen::Vector3d> map_m, const BlurSettings& settings) {
  const auto coarse = occupied_grid_points(map_m, settings.coarse_m, settings.spatial);
  if (coarse == 0) return std::numeric_limits<double>::infinity();
  const auto fine = occupied_grid_points(map_m, settings.fine_m, settings.spatial);
  // Nevalainen2021 Eq. (30); cubed spacings in space
  const double power = settings.spatial ? 3.0 : 2.0;
  return static_cast<double>(fine) * std::pow(settings.fine_m, power) /
         (static_cast<double>(coarse) * std::pow(settings.coarse_m, power));
}

}  // namespace honka
