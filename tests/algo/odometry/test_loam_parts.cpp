#include <catch2/catch.hpp>
#include <set>

#include "algo/odometry/loam/deskew.h"
#include "algo/odometry/loam/feature_map.h"
#include "algo/odometry/loam/registration.h"
#include "algo/odometry/loam/rings.h"
#include "algo/types/random.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;

namespace {

Eigen::Vector3d loam_random_point(RandomStream& random, double size_m) {
  return {random.uniform(-size_m, size_m), random.uniform(-size_m, size_m),
          random.uniform(-size_m, size_m)};
}

Twist loam_random_twist(RandomStream& random, double size_m, double size_rad) {
  Twist twist;
  twist << loam_random_point(random, size_m), loam_random_point(random, size_rad);
  return twist;
}

/// Exact matches of `count` points seen from T, edges and planes in turn; with `slab` all planes
/// have the normal z and there are no edges.
std::vector<LoamMatch> exact_matches(const Pose3& T, int count, bool slab = false) {
  RandomStream random(7, "loam_matches");
  std::vector<LoamMatch> matches;
  for (int i = 0; i < count; ++i) {
    LoamMatch match;
    match.point_m = loam_random_point(random, 20.0);
    const Eigen::Vector3d n =
        slab ? Eigen::Vector3d::UnitZ() : loam_random_point(random, 1.0).normalized();
    match.edge = !slab && i % 2 == 0;
    match.normals.row(0) = n / 0.03;
    if (match.edge) match.normals.row(1) = n.unitOrthogonal() / 0.03;
    // Any other point of the line or plane.
    const Eigen::Vector3d along = match.edge ? n.cross(Eigen::Vector3d(n.unitOrthogonal()))
                                             : Eigen::Vector3d(n.unitOrthogonal());
    match.anchor_m = T * match.point_m + random.uniform(-1.0, 1.0) * along;
    matches.push_back(match);
  }
  return matches;
}

LoamRegistrationSettings without_prior() {
  LoamRegistrationSettings s;
  s.prior_m = 10.0;
  s.prior_deg = 180.0;
  return s;
}

}  // namespace

TEST_CASE("loam: Jacobians are the numeric derivatives") {
  RandomStream random(3, "loam_jacobians");
  for (const double size : {0.0, 1e-6, 1.0, 3.0}) {
    const Pose3 T = se3_exp(loam_random_twist(random, 10.0 * size, 0.5 * size));
    for (const LoamMatch& match : exact_matches(se3_exp(loam_random_twist(random, 1, 1)), 8)) {
      const MatchJacobian analytic = match_jacobian(match, T);
      MatchJacobian numeric;
      constexpr double kStep = 1e-6;
      for (int k = 0; k < 6; ++k) {
        const Twist step = kStep * Twist::Unit(k);
        numeric.col(k) =
            (match_residual(match, T * se3_exp(step)) - match_residual(match, T * se3_exp(-step))) /
            (2.0 * kStep);
      }
      CHECK((analytic - numeric).norm() < 1e-6 * (1.0 + analytic.norm()));
    }
  }
}

TEST_CASE("loam: exact matches lead to the exact pose") {
  RandomStream random(4, "loam_exact");
  for (int i = 0; i < 5; ++i) {
    const Pose3 T = se3_exp(loam_random_twist(random, 0.3, 0.05));
    LoamRegistration result;
    const auto matches = exact_matches(T, 60);
    for (int round = 0; round < 3; ++round) {
      solve_matches(matches, result.T_odom_lidar, without_prior(), result);
    }
    CHECK(se3_log(T.inverse() * result.T_odom_lidar).norm() < 1e-4);
    CHECK(result.weak_directions == 0);
    CHECK(result.converged);
  }
}

TEST_CASE("loam: Cauchy weights bear a fifth of wrong matches") {
  RandomStream random(5, "loam_outliers");
  const Pose3 T = se3_exp(loam_random_twist(random, 0.1, 0.01));
  auto matches = exact_matches(T, 100);
  for (std::size_t i = 0; i < matches.size(); i += 5) {
    matches[i].anchor_m += loam_random_point(random, 0.5);
  }
  LoamRegistration result;
  for (int round = 0; round < 5; ++round) {
    solve_matches(matches, result.T_odom_lidar, without_prior(), result);
  }
  CHECK(se3_log(T.inverse() * result.T_odom_lidar).norm() < 0.01);
}

TEST_CASE("loam: directions that nothing observes keep the prediction to the last digit") {
  // A slab shows height, roll and pitch.
  Twist guess;
  guess << 0.4, -0.7, 0.1, 0.01, -0.02, 0.3;
  LoamRegistration result;
  result.T_odom_lidar = se3_exp(guess);
  const Pose3 T_guess = result.T_odom_lidar;
  for (int round = 0; round < 3; ++round) {
    solve_matches(exact_matches(Pose3::Identity(), 50, true), T_guess, without_prior(), result);
  }
  CHECK(result.weak_directions == 3);
  CHECK(std::abs(result.T_odom_lidar.translation().z()) < 1e-3);
  CHECK((result.T_odom_lidar.linear() * Eigen::Vector3d::UnitZ()).z() == Approx(1.0).margin(1e-7));
  CHECK(result.T_odom_lidar.translation().x() == Approx(T_guess.translation().x()).margin(0.02));
  CHECK(result.T_odom_lidar.translation().y() == Approx(T_guess.translation().y()).margin(0.02));
  CHECK(yaw_of(result.T_odom_lidar) == Approx(0.3).margin(0.001));
  CHECK(result.covariance(0, 0) > 100.0);
  CHECK(result.covariance(5, 5) > 10.0);
  CHECK(result.covariance(2, 2) < 1e-3);
  CHECK(result.covariance(3, 3) < 1e-4);
  CHECK(result.covariance.isApprox(result.covariance.transpose(), 1e-9));
}

TEST_CASE("loam: without a match the pose stays, all unobserved") {
  LoamRegistration result;
  result.T_odom_lidar = se3_exp(Twist::Constant(0.1));
  const Pose3 before = result.T_odom_lidar;
  solve_matches({}, before, LoamRegistrationSettings{}, result);
  CHECK(result.weak_directions == 6);
  CHECK(result.T_odom_lidar.isApprox(before, 1e-12));
  CHECK(result.covariance.allFinite());
}

TEST_CASE("loam: features return to one place at constant twist") {
  Twist twist;
  twist << 0.15, -0.02, 0.01, 0.005, -0.01, 0.03;
  const Eigen::Vector3d place(25.0, -8.0, 2.0);  // seen from mid-sweep
  std::vector<LoamFeature> features;
  for (const double share : {0.0, 0.01, 0.25, 0.5, 0.731, 1.0}) {
    LoamFeature f;
    f.share = share;
    f.point_m = se3_exp((share - 0.5) * twist).inverse() * place;
    features.push_back(f);
  }
  for (const Eigen::Vector3d& point : deskewed(features, twist)) {
    CHECK((point - place).norm() < 1e-4);
  }
  CHECK(deskewed({}, twist).empty());
}

TEST_CASE("loam: lines and planes of the map are those the points lie on") {
  FeatureMap map(0.5, 1.0, 100, 1000);
  RandomStream random(6, "loam_map");
  const Eigen::Vector3d along = Eigen::Vector3d(0.1, -0.05, 1.0).normalized();
  for (int i = -20; i <= 20; ++i) map.insert(Eigen::Vector3d(3, 4, 1) + 0.1 * i * along, 1.0);
  const auto line = map.line_at({3.1, 3.9, 1.2});
  REQUIRE(line);
  CHECK(std::abs(line->direction.dot(along)) == Approx(1.0).margin(1e-9));
  CHECK((line->centre_m - Eigen::Vector3d(3, 4, 1)).cross(along).norm() < 1e-9);
  CHECK(line->variance_m2 == Approx(0.0).margin(1e-9));
  CHECK_FALSE(map.plane_at({3.1, 3.9, 1.2}));
  CHECK_FALSE(map.line_at({8.0, 8.0, 1.0}));

  FeatureMap floor(0.8, 0.8, 100, 1000);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.1, 0.2, 1.0).normalized();
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(-3, 3), y = random.uniform(-3, 3);
    floor.insert({x, y, 1.0 - 0.1 * x - 0.2 * y}, 1.0);
  }
  const auto plane = floor.plane_at({0.3, 0.2, 1.0});
  REQUIRE(plane);
  CHECK(std::abs(plane->direction.dot(normal)) == Approx(1.0).margin(1e-9));
  CHECK(normal.dot(plane->centre_m) == Approx(normal.z()).margin(1e-9));
  CHECK_FALSE(floor.line_at({0.3, 0.2, 1.0}));
}

TEST_CASE("loam: weights count as that many points, and order does not matter") {
  FeatureMap once(10.0, 10.0, 100, 100), thrice(10.0, 10.0, 100, 100);
  const std::vector<Eigen::Vector3d> points = {{1, 1, 1}, {1.1, 1, 3}, {1, 1.2, 5}, {1, 1, 8}};
  for (const auto& p : points) once.insert(p, 3.0);
  for (int i = 0; i < 3; ++i) {
    for (auto p = points.rbegin(); p != points.rend(); ++p) thrice.insert(*p, 1.0);
  }
  const auto a = once.line_at({1, 1, 4}), b = thrice.line_at({1, 1, 4});
  REQUIRE((a && b));
  CHECK(a->centre_m.isApprox(b->centre_m, 1e-12));
  CHECK(std::abs(a->direction.dot(b->direction)) == Approx(1.0).margin(1e-12));
  CHECK(a->variance_m2 == Approx(b->variance_m2).margin(1e-12));
}

TEST_CASE("loam: the map is bounded, the farthest go first, what is no number is ignored") {
  FeatureMap map(0.5, 1.0, 5, 1000);
  const auto empty_bytes = map.bytes();
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 50; ++y) {
      for (int i = 0; i < 3; ++i) map.insert({0.5 * x + 0.1, 0.5 * y + 0.1, 0.3 * i}, 1.0);
    }
    map.keep_near({0.5 * x, 12.5, 0.0});
    CHECK(map.size() <= 1000);
  }
  CHECK(map.holds({99.6, 12.6, 0.1}));
  CHECK_FALSE(map.holds({0.1, 12.6, 0.1}));
  CHECK(map.bytes() < empty_bytes + 1000 * 2 * 160);
  const std::size_t before = map.size();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  map.insert({nan, 0.0, 0.0}, 1.0);
  map.insert({0.0, 1e12, 0.0}, 1.0);
  map.insert({0.0, 0.0, 0.0}, nan);
  CHECK(map.size() == before);
  CHECK_FALSE(map.line_at({nan, 0.0, 0.0}));
  CHECK_FALSE(map.plane_at({1e300, 0.0, 0.0}));
}
