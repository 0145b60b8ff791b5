#include "algo/geometry/neighbours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/geometry/cell_index.h"
#include "algo/geometry/kdtree.h"

namespace honka {
namespace {

struct ColumnPoint {
  double x, y, z;
  std::uint32_t index;
};

/// Points by column of the plane, each column sorted by height.
struct Columns {
  CellIndex cells;
  std::vector<ColumnPoint> points;
  std::vector<std::size_t> starts;

  [[nodiscard]] std::span<const ColumnPoint> column(std::size_t cell) const {
    return std::span(points).subspan(starts[cell], starts[cell + 1] - starts[cell]);
  }
};

CellIndex columns_of(std::span<const Eigen::Vector3d> points_m, double side_m) {
  Eigen::Vector2d lowest = points_m.front().head<2>(), highest = lowest;
  for (const Eigen::Vector3d& p : points_m) {
    lowest = lowest.cwiseMin(p.head<2>());
    highest = highest.cwiseMax(p.head<2>());
  }
  const CellLattice<2> lattice(lowest, highest, side_m);
  std::vector<std::uint64_t> keys(points_m.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = lattice.key(points_m[i].head<2>());
  return CellIndex(keys);
}

Columns sorted_columns(std::span<const Eigen::Vector3d> points_m, double side_m) {
  Columns columns{columns_of(points_m, side_m), {}, {0}};
  columns.points.reserve(points_m.size());
  for (std::size_t c = 0; c < columns.cells.cell_count(); ++c) {
    const auto first = static_cast<std::ptrdiff_t>(columns.points.size());
    for (const std::uint32_t i : columns.cells.members(c)) {
      columns.points.push_back({points_m[i].x(), points_m[i].y(), points_m[i].z(), i});
    }
    std::sort(columns.points.begin() + first, columns.points.end(),
              [](const ColumnPoint& a, const ColumnPoint& b) { return a.z < b.z; });
    columns.starts.push_back(columns.points.size());
  }
  return columns;
}

/// Marks the points of `below` that have a point of `above` within the radius of their raised
/// spot. Both run upwards, so one pass moves one window.
void sweep_columns(std::span<const ColumnPoint> below, std::span<const ColumnPoint> above,
                   double offset_m, double radius_m, std::vector<std::uint8_t>& found) {
  const double squared_radius = radius_m * radius_m;
  const double lowest = above.front().z, highest = above.back().z;
  std::size_t low = 0;
  for (const ColumnPoint& p : below) {
    const double z = p.z + offset_m;
    if (z - highest >= radius_m) return;
    if (lowest - z >= radius_m || found[p.index] != 0) continue;
    while (z - above[low].z >= radius_m) ++low;  // ends: the highest is not that far below
    for (std::size_t k = low; k < above.size() && above[k].z - z < radius_m; ++k) {
      const double dx = p.x - above[k].x, dy = p.y - above[k].y, dz = z - above[k].z;
      if (dx * dx + dy * dy + dz * dz < squared_radius) {
        found[p.index] = 1;
        break;
      }
    }
  }
}

bool lower(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); }

std::vector<std::uint8_t> above_by_columns(std::span<const Eigen::Vector3d> points_m,
                                           double offset_m, double radius_m) {
  std::vector<std::uint8_t> found(points_m.size(), 0);
  if (points_m.empty()) return found;
  const Columns columns = sorted_columns(points_m, radius_m * kWide);
  // The own column first: for a stem it answers nearly always.
  constexpr std::array<std::array<int, 2>, 9> kAround = {
      {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  const double highest = std::max_element(points_m.begin(), points_m.end(), lower)->z();
  for (std::size_t c = 0; c < columns.cells.cell_count(); ++c) {
    const std::span<const ColumnPoint> below = columns.column(c);
    if (below.front().z + offset_m - highest >= radius_m) continue;
    for (const std::array<int, 2>& around : kAround) {
      const auto cell = columns.cells.find(columns.cells.key(c) + CellLattice<2>::step(around));
      if (cell) sweep_columns(below, columns.column(*cell), offset_m, radius_m, found);
    }
  }
  return found;
}

std::vector<std::uint8_t> other_by_cells(std::span<const Eigen::Vector2d> points_m,
                                         double radius_m) {
  const CellLattice<2> lattice(points_m, radius_m * kNarrow / std::sqrt(2.0));
  std::vector<std::uint64_t> keys(points_m.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = lattice.key(points_m[i]);
  const CellIndex cells(keys);
  const auto near_in = [&](std::uint32_t i, std::uint64_t key) {
    const auto cell = cells.find(key);
    if (!cell) return false;
    const auto members = cells.members(*cell);
    return std::any_of(members.begin(), members.end(), [&](std::uint32_t k) {
      const double dx = points_m[i].x() - points_m[k].x();
      const double dy = points_m[i].y() - points_m[k].y();
      return dx * dx + dy * dy < radius_m * radius_m;
    });
  };
  std::vector<std::uint8_t> found(points_m.size(), 0);
  for (std::uint32_t i = 0; i < points_m.size(); ++i) {
    if (cells.members(cells.cell_of(i)).size() > 1) {  // a cell's diagonal is below the radius
      found[i] = 1;
      continue;
    }
    for (int dx = -2; dx <= 2 && found[i] == 0; ++dx) {
      for (int dy = -2; dy <= 2 && found[i] == 0; ++dy) {
        if (dx == 0 && dy == 0) continue;
        found[i] = near_in(i, keys[i] + CellLattice<2>::step({dx, dy})) ? 1 : 0;
      }
    }
  }
  return found;
}

}  // namespace

std::vector<std::uint8_t> has_neighbour_above(std::span<const Eigen::Vector3d> points_m,
                                              double offset_m, double radius_m,
                                              NeighbourSearch search) {
  if (search == NeighbourSearch::kVoxelHash) {
    return above_by_columns(points_m, offset_m, radius_m);
  }
  const KdTree3 tree(points_m);
  std::vector<std::uint8_t> found(points_m.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Eigen::Vector3d spot(points_m[i].x(), points_m[i].y(), points_m[i].z() + offset_m);
    found[i] = tree.any_within(spot, radius_m) ? 1 : 0;
  }
  return found;
}

std::vector<std::uint8_t> has_other_within(std::span<const Eigen::Vector2d> points_m,
                                           double radius_m, NeighbourSearch search) {
  if (search == NeighbourSearch::kVoxelHash) return other_by_cells(points_m, radius_m);
  const KdTree2 tree(points_m);
  std::vector<std::uint8_t> found(points_m.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) {
    found[i] = tree.any_within(points_m[i], radius_m, i) ? 1 : 0;
  }
  return found;
}

}  // namespace honka
