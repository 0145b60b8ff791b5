#include <algorithm>
#include <array>
#include <cmath>

#include "algo/geometry/cell_index.h"
#include "algo/geometry/disjoint_sets.h"
#include "algo/geometry/kdtree.h"
#include "algo/geometry/neighbours.h"

namespace honka {
namespace {

template <int Dim>
using Points = std::span<const Eigen::Matrix<double, Dim, 1>>;

template <int Dim>
bool near(const Eigen::Matrix<double, Dim, 1>& a, const Eigen::Matrix<double, Dim, 1>& b,
          double squared_link) {
  double sum = 0.0;  // in the order of the k-d tree's metric: the same digits
  for (int axis = 0; axis < Dim; ++axis) {
    const double d = a[axis] - b[axis];
    sum += d * d;
  }
  return sum < squared_link;
}

/// Half of the steps to cells that can hold a point within the link of one in this cell.
template <int Dim>
std::vector<std::uint64_t> half_of_the_steps() {
  std::vector<std::uint64_t> steps;
  std::array<int, Dim> d{};
  const int count = Dim == 2 ? 25 : 125;
  for (int code = count / 2 + 1; code < count; ++code) {  // the middle one is (0, 0…)
    int rest = code;
    for (int axis = 0; axis < Dim; ++axis, rest /= 5)
      d[static_cast<std::size_t>(axis)] = rest % 5 - 2;
    steps.push_back(CellLattice<Dim>::step(d));
  }
  return steps;
}

template <int Dim>
bool any_pair_near(Points<Dim> points, std::span<const std::uint32_t> a,
                   std::span<const std::uint32_t> b, double squared_link) {
  for (const std::uint32_t i : a) {
    for (const std::uint32_t k : b) {
      if (near<Dim>(points[i], points[k], squared_link)) return true;
    }
  }
  return false;
}

/// All points of a cell are one set, since its diagonal is below the link; cells are then joined
/// by the first near pair.
template <int Dim>
DisjointSets sets_by_cells(Points<Dim> points, double link_m) {
  const CellLattice<Dim> lattice(points, link_m * kNarrow / std::sqrt(static_cast<double>(Dim)));
  std::vector<std::uint64_t> keys(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = lattice.key(points[i]);
  const CellIndex cells(keys);
  const std::vector<std::uint64_t> steps = half_of_the_steps<Dim>();
  DisjointSets sets(points.size());
  for (std::size_t c = 0; c < cells.cell_count(); ++c) {
    for (const std::uint32_t i : cells.members(c)) sets.join(cells.members(c).front(), i);
  }
  for (std::size_t c = 0; c < cells.cell_count(); ++c) {
    const auto own = cells.members(c);
    for (const std::uint64_t step : steps) {
      const auto cell = cells.find(cells.key(c) + step);
      if (!cell) continue;
      const auto other = cells.members(*cell);
      if (sets.root(own.front()) == sets.root(other.front())) continue;
      if (any_pair_near<Dim>(points, own, other, link_m * link_m)) {
        sets.join(own.front(), other.front());
      }
    }
  }
  return sets;
}

/// Points round a first one, nearer to it than half the link and therefore to each other than the
/// link. Where hundreds of points lie within one link, asking each for its neighbours costs their
/// square; asking the clumps does not, and finds the same sets.
template <int Dim>
std::vector<std::vector<std::uint32_t>> clumps_of(Points<Dim> points, const KdTree<Dim>& tree,
                                                  double link_m) {
  std::vector<std::vector<std::uint32_t>> clumps;
  std::vector<std::uint8_t> taken(points.size(), 0);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (taken[i] != 0) continue;
    tree.within(points[i], 0.5 * link_m * kNarrow, found);
    std::vector<std::uint32_t>& clump = clumps.emplace_back(1, i);
    for (const std::uint32_t k : found) {
      if (k != i && taken[k] == 0) clump.push_back(k);
    }
    for (const std::uint32_t k : clump) taken[k] = 1;
  }
  return clumps;
}

template <int Dim>
DisjointSets sets_by_tree(Points<Dim> points, double link_m) {
  const KdTree<Dim> tree(points);
  const auto clumps = clumps_of<Dim>(points, tree, link_m);
  DisjointSets sets(points.size());
  for (const auto& clump : clumps) {
    for (const std::uint32_t i : clump) sets.join(clump.front(), i);
  }
  std::vector<std::uint32_t> found;
  for (const auto& clump : clumps) {
    // Half a link to the farthest member and a link to its neighbour.
    tree.within(points[clump.front()], 1.5 * link_m / kNarrow, found);
    for (const std::uint32_t k : found) {
      if (sets.root(clump.front()) == sets.root(k)) continue;
      if (any_pair_near<Dim>(points, clump, std::span(&k, 1), link_m * link_m)) {
        sets.join(clump.front(), k);
      }
    }
  }
  return sets;
}

}  // namespace

template <int Dim>
std::vector<std::uint32_t> euclidean_clusters(Points<Dim> points_m, double link_m,
                                              NeighbourSearch search) {
  DisjointSets sets = search == NeighbourSearch::kKdTree ? sets_by_tree<Dim>(points_m, link_m)
                                                         : sets_by_cells<Dim>(points_m, link_m);
  std::vector<std::uint32_t> labels(points_m.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) labels[i] = sets.root(i);
  return labels;
}

template std::vector<std::uint32_t> euclidean_clusters<2>(Points<2>, double, NeighbourSearch);
template std::vector<std::uint32_t> euclidean_clusters<3>(Points<3>, double, NeighbourSearch);

}  // namespace honka
