#include "sim/harvester/paths.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "sim/harvester/smooth_path.h"

namespace honka::sim {
namespace {

const Eigen::AlignedBox2d kStand(Eigen::Vector2d(0, 0), Eigen::Vector2d(200, 300));

/// Sharpest turn per metre over windows of 2 m.
double sharpest_curvature(const Polyline& path) {
  double sharpest = 0.0;
  const SmoothPath curve(path);
  for (double s = 1.0; s + 1.0 < curve.length_m(); s += 0.25) {
    const Eigen::Vector2d a = curve.at(s) - curve.at(s - 1.0), b = curve.at(s + 1.0) - curve.at(s);
    sharpest = std::max(sharpest,
                        std::fabs(wrap_to_pi(std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x()))));
  }
  return sharpest;
}

}  // namespace

TEST_CASE("work paths wind through the middle and keep the machine's turning radius") {
  std::vector<Polyline> paths;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Polyline path = work_path(kStand, 200.0, seed);
    CHECK(length_m(path) == Approx(200.0));
    for (const Eigen::Vector2d& p : path) {
      REQUIRE(kStand.contains(p));
      REQUIRE((p - kStand.min()).minCoeff() >= 40.0 - 1e-9);
      REQUIRE((kStand.max() - p).minCoeff() >= 40.0 - 1e-9);
    }
    CHECK(sharpest_curvature(path) <= 1.02 / kTurningRadius_m);
    // It winds: the way is longer than the straight line.
    CHECK((path.back() - path.front()).norm() < 199.0);
    paths.push_back(path);
  }
  CHECK(work_path(kStand, 200.0, 3) == paths[3]);
  int north = 0;
  for (const Polyline& path : paths) north += path.back().y() > path.front().y() ? 1 : 0;
  CHECK(north > 5);
  CHECK(north < 25);
}

TEST_CASE("the prior run covers every road, turns outside and never tighter than asked") {
  const Polyline path = prior_run_path(kStand, 50.0);
  double inside = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Vector2d middle = 0.5 * (path[i] + path[i - 1]);
    if (kStand.contains(middle)) inside += (path[i] - path[i - 1]).norm();
  }
  CHECK(inside == Approx(1200.0).margin(1e-6));
  for (const Polyline& road : strip_roads(kStand, 50.0)) {
    for (double s = 0.0; s <= 300.0; s += 10.0) CHECK(distance_m(path, point_at(road, s)) < 1e-9);
  }
  CHECK(sharpest_curvature(path) <= 1.05 / kTurningRadius_m);
}

TEST_CASE("a smooth path keeps a straight line and its length, and goes on beyond its ends") {
  const SmoothPath path({{1, 2}, {4, 6}});
  CHECK(path.length_m() == Approx(5.0));
  for (const double s : {-3.0, 0.0, 0.3, 2.5, 5.0, 9.0}) {
    CHECK((path.at(s) - (Eigen::Vector2d(1, 2) + s * Eigen::Vector2d(0.6, 0.8))).norm() < 1e-9);
  }
}

TEST_CASE("helpers of a polyline measure, walk and resample it") {
  const Polyline line = {{0, 0}, {3, 0}, {3, 4}};
  CHECK(length_m(line) == Approx(7.0));
  CHECK(length_m({}) == 0.0);
  CHECK(point_at(line, 5.0) == Eigen::Vector2d(3, 2));
  CHECK(point_at(line, -1.0) == Eigen::Vector2d(0, 0));
  CHECK(point_at(line, 99.0) == Eigen::Vector2d(3, 4));
  CHECK(distance_m(line, {5, 2}) == Approx(2.0));
  CHECK(std::isinf(distance_m({}, {5, 2})));
  const Polyline fine = resampled(line, 0.5);
  REQUIRE(fine.size() == 15);
  for (std::size_t i = 0; i < fine.size(); ++i) {
    CHECK((fine[i] - point_at(line, 0.5 * static_cast<double>(i))).norm() < 1e-9);
  }
}

}  // namespace honka::sim
