// The parts of branch and bound: exact neighbours, bounds that really bound, a search that finds.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algo/slam/registration/go_icp_search.h"
#include "tests/algo/slam/registration_pairs.h"

namespace {

using namespace honka;
using FlatPoints = std::vector<Eigen::Vector2d>;

FlatPoints flat_points(std::size_t count, double side_m, std::uint64_t id) {
  FlatPoints flat;
  for (const auto& p : test::random_stems(count, side_m, id)) flat.emplace_back(p.head<2>());
  return flat;
}

PlanarMotion motion_within(const MotionBox& box, RandomStream& random) {
  PlanarMotion motion = box.middle;
  motion.yaw_rad += random.uniform(-1.0, 1.0) * box.half_yaw_rad;
  motion.shift_m.x() += random.uniform(-1.0, 1.0) * box.half_shift_m.x();
  motion.shift_m.y() += random.uniform(-1.0, 1.0) * box.half_shift_m.y();
  return motion;
}

bool holds(const MotionBox& box, const PlanarMotion& motion) {
  return std::abs(motion.yaw_rad - box.middle.yaw_rad) <= box.half_yaw_rad &&
         ((motion.shift_m - box.middle.shift_m).cwiseAbs().array() <= box.half_shift_m.array())
             .all();
}

/// The objective by looking at every pair of points.
double brute_force_rmse(const FlatPoints& target, const FlatPoints& source,
                        const PlanarMotion& motion, std::size_t inliers) {
  std::vector<double> squared;
  for (const Eigen::Vector2d& p : source) {
    const Eigen::Vector2d moved = Eigen::Rotation2Dd(motion.yaw_rad) * p + motion.shift_m;
    double best = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& q : target) best = std::min(best, (q - moved).squaredNorm());
    squared.push_back(best);
  }
  std::sort(squared.begin(), squared.end());
  double sum = 0.0;
  for (std::size_t k = 0; k < inliers; ++k) sum += squared[k];
  return std::sqrt(sum / static_cast<double>(inliers));
}

TEST_CASE("A grid of stems finds the nearest one, inside it and far beyond") {
  for (const std::size_t count :
       {std::size_t{1}, std::size_t{2}, std::size_t{9}, std::size_t{110}}) {
    FlatPoints points = flat_points(count, 60.0, count);
    points.push_back(points.front());  // a duplicate
    const StemGrid grid(points, 10.0);
    RandomStream random(3, "grid_queries", {count});
    for (int k = 0; k < 2000; ++k) {
      const double reach = k % 10 == 0 ? 500.0 : 45.0;
      const double x = random.uniform(-reach, reach);
      const double y = random.uniform(-reach, reach);
      std::size_t nearest = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto away = [&](std::size_t n) { return (points[n] - Eigen::Vector2d(x, y)).norm(); };
        if (away(i) < away(nearest)) nearest = i;
      }
      CHECK(grid.nearest(x, y) == nearest);
      double squared = 0.0;
      grid.squared_distances(std::span(&x, 1), std::span(&y, 1), std::span(&squared, 1));
      CHECK(squared == Approx((points[nearest] - Eigen::Vector2d(x, y)).squaredNorm()));
    }
  }
}

TEST_CASE("The trimmed objective is the RMSE of the nearest part of the points") {
  const FlatPoints target = flat_points(80, 50.0, 1);
  const FlatPoints source = flat_points(60, 50.0, 2);
  RandomStream random(3, "objective");
  const MotionBox anywhere{{}, 3.0, {20.0, 20.0}};
  for (const std::size_t inliers : {std::size_t{1}, std::size_t{24}, std::size_t{60}}) {
    TrimmedObjective objective(target, source, inliers, 10.0);
    for (int k = 0; k < 100; ++k) {
      const PlanarMotion motion = motion_within(anywhere, random);
      CHECK(objective.rmse(motion) ==
            Approx(brute_force_rmse(target, source, motion, inliers)).margin(1e-12));
    }
  }
}

TEST_CASE("No motion in a box is better than its bound", "[bounds]") {
  // Nevalainen2021 Eq. (22): boxes large, small, thin, and of no width at all.
  const FlatPoints target = flat_points(80, 50.0, 3);
  const FlatPoints source = flat_points(60, 50.0, 4);
  RandomStream random(3, "boxes");
  int positive = 0;
  for (int k = 0; k < 400; ++k) {
    TrimmedObjective objective(target, source, k % 2 == 0 ? 24 : 60, 10.0);
    const double size = std::exp(random.uniform(std::log(1e-3), std::log(3.0)));
    MotionBox box = {{random.uniform(-3.0, 3.0), {random.uniform(-9, 9), random.uniform(-9, 9)}},
                     size * random.uniform() / 20.0,
                     {size * random.uniform(), size * random.uniform()}};
    if (k % 20 == 0) box.half_yaw_rad = 4.0;
    const double enough_m = k % 3 == 0 ? 0.3 : 1e9;
    const auto bound = objective.bound(box, 1e9, enough_m);
    CHECK(bound.middle_m == Approx(objective.rmse(box.middle)).margin(1e-12));
    CHECK(bound.lower_m <= bound.middle_m + 1e-12);
    positive += bound.lower_m > 0.0 ? 1 : 0;
    for (int n = 0; n < 40; ++n) {
      CHECK(objective.rmse(motion_within(box, random)) >= bound.lower_m - 1e-12);
    }
  }
  CHECK(positive > 100);  // bounds of 0 would hold as well
}

TEST_CASE("A bound reaches as far as a turn and a shift can, and no farther", "[bounds]") {
  // One point 10 m out; the target lies where the corner of the box takes it, or 1 cm beyond.
  const FlatPoints source = {{10.0, 0.0}, {10.0, 0.0}};
  for (const double turn_rad : {0.02, 0.4, 2.0}) {
    const MotionBox turns = {{0.0, {0.0, 0.0}}, turn_rad, {0.0, 0.0}};
    const Eigen::Vector2d reached(10.0 * std::cos(turn_rad), 10.0 * std::sin(turn_rad));
    const Eigen::Vector2d away = (reached - source[0]).normalized();
    TrimmedObjective there({{reached}}, source, 2, 30.0);
    CHECK(there.bound(turns, 1e9, 1e9).lower_m == Approx(0.0).margin(1e-12));
    TrimmedObjective beyond({{Eigen::Vector2d(reached + 0.01 * away)}}, source, 2, 30.0);
    CHECK(beyond.bound(turns, 1e9, 1e9).lower_m == Approx(0.01));
  }
  const MotionBox shifts = {{0.0, {0.0, 0.0}}, 0.0, {0.3, 0.4}};
  TrimmedObjective there({{Eigen::Vector2d(10.3, 0.4)}}, source, 2, 30.0);
  CHECK(there.bound(shifts, 1e9, 1e9).lower_m == Approx(0.0).margin(1e-12));
  TrimmedObjective beyond({{Eigen::Vector2d(10.36, 0.48)}}, source, 2, 30.0);
  CHECK(beyond.bound(shifts, 1e9, 1e9).lower_m == Approx(0.1));
}

TEST_CASE("What a search knows of boxes that it did not cut is part of its lower bound") {
  TrimmedObjective objective(flat_points(30, 30.0, 6), flat_points(25, 30.0, 7), 10, 10.0);
  const MotionBox region{{0.3, {1.0, 2.0}}, 0.04, {0.5, 0.5}};
  SearchLimits limits;
  limits.gap_m = 0.001;
  limits.leaf = region;
  const SearchResult found = branch_and_bound(objective, {region}, region.middle, limits);
  CHECK(found.nodes == 1);
  const double lower_m = objective.bound(region, 1e9, 1e9).lower_m;
  CHECK(found.lower_m == Approx(lower_m));
  CHECK((lower_m > 0.0 && lower_m < found.best_m));

  const SearchResult none = branch_and_bound(objective, {}, region.middle, limits);
  CHECK(none.nodes == 0);
  CHECK(none.best_m == found.best_m);
}

TEST_CASE("A box without width is bounded by its middle") {
  TrimmedObjective objective(flat_points(80, 50.0, 3), flat_points(60, 50.0, 4), 24, 10.0);
  const MotionBox point = {{0.3, {1.0, 2.0}}, 0.0, {0.0, 0.0}};
  CHECK(objective.bound(point, 1e9, 1e9).lower_m == Approx(objective.rmse(point.middle)));
}

TEST_CASE("ICP ends no worse than it began, and on the match that it began beside") {
  const FlatPoints source = flat_points(60, 50.0, 5);
  const PlanarMotion truth{0.4, {3.0, -2.0}};
  FlatPoints target;
  for (const auto& p : source) {
    target.push_back(Eigen::Rotation2Dd(truth.yaw_rad) * p + truth.shift_m);
  }
  TrimmedObjective objective(target, source, 40, 10.0);
  RandomStream random(3, "polish");
  for (int k = 0; k < 50; ++k) {
    const MotionBox around{truth, 0.5, {5.0, 5.0}};
    const PlanarMotion start = motion_within(around, random);
    CHECK(objective.rmse(objective.polish(start)) <= objective.rmse(start) + 1e-12);
  }
  const PlanarMotion end = objective.polish({0.41, {3.2, -2.1}});
  CHECK(std::abs(end.yaw_rad - truth.yaw_rad) < 1e-6);
  CHECK((end.shift_m - truth.shift_m).norm() < 1e-6);
}

TEST_CASE("Branch and bound ends at a fine grid's best, whatever the shape of the region") {
  const FlatPoints target = flat_points(30, 30.0, 6);
  const FlatPoints source = flat_points(25, 30.0, 7);  // unlike the target: the optimum is nowhere
  TrimmedObjective objective(target, source, 10, 10.0);
  SearchLimits limits;
  limits.gap_m = 0.02;
  for (const MotionBox& region : {MotionBox{{0.0, {0.0, 0.0}}, 0.3, {2.0, 2.0}},
                                  MotionBox{{1.0, {3.0, -1.0}}, 0.05, {4.0, 0.5}},
                                  MotionBox{{-2.0, {0.0, 5.0}}, 0.5, {0.2, 0.3}}}) {
    const SearchResult found = branch_and_bound(objective, {region}, region.middle, limits);
    CHECK_FALSE(found.capped);
    CHECK(found.best_m - found.lower_m <= 0.02 + 1e-12);
    CHECK(objective.rmse(found.best) == Approx(found.best_m));
    RandomStream random(3, "grid_best");
    double best = found.best_m;
    for (int k = 0; k < 3000; ++k) {
      const PlanarMotion start = motion_within(region, random);
      const PlanarMotion end = objective.polish(start);
      best = std::min(best, objective.rmse(holds(region, end) ? end : start));
    }
    CHECK(found.lower_m <= best + 1e-9);
  }
}

}  // namespace
