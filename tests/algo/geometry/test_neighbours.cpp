#include <catch2/catch.hpp>
#include <set>

#include "algo/geometry/kdtree.h"
#include "algo/geometry/neighbours.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

template <int Dim>
std::vector<Eigen::Matrix<double, Dim, 1>> random_points(std::uint64_t seed, int count,
                                                         double side_m, bool lattice) {
  RandomStream random(seed, "points");
  std::vector<Eigen::Matrix<double, Dim, 1>> points(static_cast<std::size_t>(count));
  for (auto& p : points) {
    for (int axis = 0; axis < Dim; ++axis) p[axis] = random.uniform(-side_m, side_m);
    if (lattice) p = (p.array() * 8.0).round() / 8.0;  // ties and duplicates everywhere
  }
  return points;
}

template <int Dim>
std::vector<std::uint32_t> brute_clusters(const std::vector<Eigen::Matrix<double, Dim, 1>>& points,
                                          double link_m) {
  std::vector<std::uint32_t> labels(points.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) labels[i] = i;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < points.size(); ++k) {
        if ((points[i] - points[k]).squaredNorm() < link_m * link_m && labels[k] < labels[i]) {
          labels[i] = labels[k];
          changed = true;
        }
      }
    }
  }
  return labels;
}

constexpr auto kBoth = {NeighbourSearch::kKdTree, NeighbourSearch::kVoxelHash};

}  // namespace

TEST_CASE("has_neighbour_above agrees with all pairs") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = random_points<3>(seed, 400, 3.0, seed % 2 == 0);
    const double offset_m = seed % 3 == 0 ? 0.5 : 2.0, radius_m = seed % 5 == 0 ? 0.5 : 0.31;
    for (const NeighbourSearch search : kBoth) {
      const auto found = has_neighbour_above(points, offset_m, radius_m, search);
      for (std::size_t i = 0; i < points.size(); ++i) {
        bool expected = false;
        for (const auto& other : points) {
          const Eigen::Vector3d d = points[i] + Eigen::Vector3d(0, 0, offset_m) - other;
          expected = expected || d.squaredNorm() < radius_m * radius_m;
        }
        CHECK((found[i] != 0) == expected);
      }
    }
  }
}

TEST_CASE("has_other_within agrees with all pairs") {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto points = random_points<2>(seed, 300, 3.0, seed % 2 == 0);
    const double radius_m = seed % 4 == 0 ? 0.125 : 0.1 + 0.01 * static_cast<double>(seed);
    for (const NeighbourSearch search : kBoth) {
      const auto found = has_other_within(points, radius_m, search);
      for (std::size_t i = 0; i < points.size(); ++i) {
        bool expected = false;
        for (std::size_t k = 0; k < points.size(); ++k) {
          expected =
              expected || (k != i && (points[i] - points[k]).squaredNorm() < radius_m * radius_m);
        }
        CHECK((found[i] != 0) == expected);
      }
    }
  }
}

TEST_CASE("euclidean clusters agree with the closure of all pairs") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const bool lattice = seed % 2 == 0;
    const double link_m = lattice ? 0.25 : 0.3;
    const auto flat = random_points<2>(seed, 200, 3.0, lattice);
    const auto deep = random_points<3>(seed, 200, 1.2, lattice);
    for (const NeighbourSearch search : kBoth) {
      CHECK(euclidean_clusters<2>(flat, link_m, search) == brute_clusters<2>(flat, link_m));
      CHECK(euclidean_clusters<3>(deep, link_m, search) == brute_clusters<3>(deep, link_m));
    }
  }
}

TEST_CASE("searches over nothing and over one point") {
  for (const NeighbourSearch search : kBoth) {
    CHECK(has_neighbour_above({}, 2.0, 0.3, search).empty());
    CHECK(has_other_within({}, 0.05, search).empty());
    CHECK(euclidean_clusters<2>({}, 0.2, search).empty());
    const std::vector<Eigen::Vector2d> one = {{1e6, -1e6}};
    CHECK(has_other_within(one, 0.05, search) == std::vector<std::uint8_t>{0});
    CHECK(euclidean_clusters<2>(one, 0.2, search) == std::vector<std::uint32_t>{0});
  }
}

TEST_CASE("k-d tree searches agree with a look at every point") {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto points = random_points<3>(seed, 300, 2.0, false);
    const KdTree3 tree(points);
    const Eigen::Vector3d query = random_points<3>(seed + 100, 1, 2.0, false)[0];
    std::set<std::pair<double, std::uint32_t>> by_distance;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      by_distance.emplace((points[i] - query).norm(), i);
    }
    CHECK(tree.nearest(query)->index == by_distance.begin()->second);
    const auto five = tree.nearest(query, 5);
    auto expected = by_distance.begin();
    for (const Neighbour& n : five) CHECK(n.index == (expected++)->second);
    std::vector<std::uint32_t> within;
    for (std::uint32_t i = 0; i < points.size(); ++i) {
      if ((points[i] - query).norm() < 0.7) within.push_back(i);
    }
    CHECK(tree.within(query, 0.7) == within);
    CHECK(tree.any_within(query, 0.7) == !within.empty());
    CHECK_FALSE(tree.any_within(points[3], 1e-6, 3));
  }
  const KdTree2 empty{std::span<const Eigen::Vector2d>{}};
  CHECK_FALSE(empty.nearest({0.0, 0.0}).has_value());
  CHECK(empty.nearest({0.0, 0.0}, 3).empty());
  CHECK(empty.within({0.0, 0.0}, 1.0).empty());
}
