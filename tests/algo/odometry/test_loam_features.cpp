#include <catch2/catch.hpp>
#include <set>

#include "algo/odometry/loam/features.h"
#include "algo/odometry/loam/rings.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;

namespace {

/// A ring along a straight wall: points (x, 5, 0) with x rising by `step_m`.
Ring wall_ring(int count, double step_m) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    RingPoint p;
    p.point_m = {step_m * (i - count / 2), 5.0, 0.0};
    p.range_m = p.point_m.norm();
    p.firing = i;
    ring.push_back(p);
  }
  return ring;
}

Pose3 still_at(const Eigen::Vector3d& place_m) { return pose_from_rpy(place_m, 0.0, 0.0, 0.0); }

Sweep still_scan(const stem_world::World& world) {
  return stem_world::scan(
      world, vlp16(),
      [](double) {
        return still_at({0, 0, 1.5});
      },
      0, 0.0);
}

}  // namespace

TEST_CASE("loam: curvature is zero on a line and known at its corner") {
  const Ring line = wall_ring(21, 0.1);
  CHECK(curvature_at(line, 10) == Approx(0.0).margin(1e-12));
  Ring corner = line;
  // The second half bends away by a right angle: x stays, y grows.
  for (std::size_t i = 11; i < corner.size(); ++i) {
    corner[i].point_m = {0.0, 5.0 + 0.1 * (static_cast<double>(i) - 10.0), 0.0};
  }
  // Σ of 5 points back, Σ of 5 points aside: (−1.5, 1.5) m over 10 · 5 m.
  CHECK(curvature_at(corner, 10) == Approx(1.5 * std::sqrt(2.0) / 50.0));
  CHECK(curvature_at(Ring(1), 0) == 0.0);
}

TEST_CASE("loam: a lost shot does not end a run, a step or a hole does") {
  Ring ring = wall_ring(30, 0.05);
  CHECK(runs_of(ring, 0.3, 0, 29).size() == 1);
  ring.erase(ring.begin() + 15);
  CHECK(runs_of(ring, 0.3, 0, 29).size() == 1);
  ring.erase(ring.begin() + 15);
  CHECK(runs_of(ring, 0.3, 0, 29).size() == 2);
  Ring step = wall_ring(30, 0.05);
  for (std::size_t i = 10; i < 20; ++i) step[i].range_m -= 1.0;
  const auto runs = runs_of(step, 0.3, 0, 29);
  REQUIRE(runs.size() == 3);
  CHECK(runs[1].begin == 10);
  CHECK(runs[1].end == 20);
  CHECK((runs[1].free_begin && runs[1].free_end));  // before the wall
  CHECK_FALSE((runs[0].free_end || runs[2].free_begin));
  CHECK(runs_of({}, 0.3, 0, 29).empty());
  // At the rim of the view, and five firings from it.
  CHECK_FALSE(runs_of(step, 0.3, 0, 29).front().free_begin);
  CHECK(runs_of(step, 0.3, -5, 34).front().free_begin);
  CHECK(runs_of(step, 0.3, -5, 34).front().alone);
  CHECK_FALSE(runs_of(step, 0.3, 0, 29).back().free_end);
  CHECK(runs_of(step, 0.3, -5, 34).back().free_end);
}

TEST_CASE("loam: edges lie on the axes of stems, planes on the ground") {
  stem_world::World world;
  world.trunks = {{{8, 1}, {0, 0}, 0.15},
                  {{12, -6}, {0, 0}, 0.1},
                  {{5, 4}, {0, 0}, 0.2},
                  {{15, 8}, {0, 0}, 0.18}};
  const LoamFeatures features = extract_loam_features(still_scan(world), vlp16(), {});
  CHECK(features.edges.size() > 30);
  std::set<std::size_t> seen;
  for (const LoamFeature& edge : features.edges) {
    for (std::size_t i = 0; i < world.trunks.size(); ++i) {
      const double off_m = (edge.point_m.head<2>() - world.trunks[i].foot_m).norm();
      if (off_m > 0.5) continue;
      seen.insert(i);
      CHECK(off_m < 0.06);  // the step of azimuth is 5 cm at 15 m
    }
  }
  CHECK(seen.size() == 4);
  CHECK(features.planes.size() > 100);
  for (const LoamFeature& plane : features.planes) {
    CHECK(plane.point_m.z() == Approx(-1.5).margin(0.005));
  }
}

TEST_CASE("loam: a stem that is half behind another is no edge") {
  stem_world::World world;
  world.trunks = {{{8, 0}, {0, 0}, 0.15}, {{12, 0.25}, {0, 0}, 0.15}};
  const LoamFeatures features = extract_loam_features(still_scan(world), vlp16(), {});
  CHECK_FALSE(features.edges.empty());
  for (const LoamFeature& edge : features.edges) CHECK(edge.point_m.x() < 10.0);
}

TEST_CASE("loam: the machine's own returns and far ones are no features") {
  stem_world::World world;
  world.trunks = {{{3.0, 0}, {0, 0}, 0.1}, {{50, 10}, {0, 0}, 0.4}};
  world.ground = false;
  LoamFeatureSettings settings;
  settings.max_range_m = 40.0;
  CHECK(extract_loam_features(still_scan(world), vlp16(), settings).edges.empty());
  settings.min_range_m = 1.0;
  CHECK_FALSE(extract_loam_features(still_scan(world), vlp16(), settings).edges.empty());
}

TEST_CASE("loam: returns that no sensor sends are left out") {
  Sweep sweep;
  CHECK(extract_loam_features(sweep, vlp16(), {}).edges.empty());
  Return r;
  r.range_ticks = 65535;
  r.laser = 200;
  r.time_offset_ns = 4294967295U;
  sweep.returns.assign(100, r);
  for (int i = 0; i < 100; ++i) sweep.returns[static_cast<std::size_t>(i)].laser %= 17;
  for (const Ring& ring : rings_of(sweep, vlp16()).of_laser) CHECK(ring.empty());
  r.time_offset_ns = 500;
  r.laser = 3;
  sweep.returns.assign(100, r);  // one shot a hundred times is one shot
  CHECK(rings_of(sweep, vlp16()).of_laser[3].size() == 1);
}

TEST_CASE("loam: thinning keeps the order and the number") {
  std::vector<LoamFeature> features(10);
  for (std::size_t i = 0; i < 10; ++i) features[i].range_m = static_cast<double>(i);
  CHECK(thinned(features, 20).size() == 10);
  const auto few = thinned(features, 3);
  REQUIRE(few.size() == 3);
  CHECK((few[0].range_m < few[1].range_m && few[1].range_m < few[2].range_m));
}
