#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "sim/lidar/cone_pieces.h"
#include "sim/lidar/ray_cone.h"
#include "sim/lidar/ray_ellipsoid.h"

namespace honka::sim {
namespace {

Ray towards(const Eigen::Vector3d& origin, const Eigen::Vector3d& aim) {
  const Eigen::Vector3d d = (aim - origin).normalized();
  return {origin.x(), origin.y(), origin.z(), d.x(), d.y(), d.z()};
}

Eigen::Vector3d at(const Ray& r, double t) {
  return {r.ox + t * r.dx, r.oy + t * r.dy, r.oz + t * r.dz};
}

/// Distance to the axis less the cone's radius there, and the share along the axis.
std::pair<double, double> off_mantle(const Cone& c, const Eigen::Vector3d& p) {
  const Eigen::Vector3d e = c.b_m - c.a_m;
  const double u = (p - c.a_m).dot(e) / e.squaredNorm();
  const double radius = c.radius_a_m + u * (c.radius_b_m - c.radius_a_m);
  return {(p - c.a_m - u * e).norm() - radius, u};
}

Eigen::Vector3d random_point(RandomStream& s, double reach) {
  return {s.uniform(-reach, reach), s.uniform(-reach, reach), s.uniform(-reach, reach)};
}

}  // namespace

TEST_CASE("a hit lies on the mantle, and nothing of the mantle lies before it") {
  int hits = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    RandomStream s(3, "cones", {i});
    const Eigen::Vector3d a = random_point(s, 3.0), b = random_point(s, 3.0);
    Cone cone = {a, b, s.uniform(0.01, 1.0), s.uniform(0.0, 1.0), {}};
    const Ray ray = towards(random_point(s, 8.0), a + s.uniform() * (b - a) + random_point(s, 0.5));
    const double t = intersect(ray, packed(cone), 0.0, 100.0);
    const double sign = off_mantle(cone, at(ray, 0.0)).first;
    const double end = t == kNoHit ? 20.0 : t;
    if (t != kNoHit) {
      ++hits;
      const auto [off, u] = off_mantle(cone, at(ray, t));
      CHECK(std::fabs(off) < 1e-5);
      const double lip = kJointOverlap / (b - a).norm() + 1e-5;
      CHECK(u >= -lip * cone.radius_a_m - 1e-5);
      CHECK(u <= 1.0 + lip * cone.radius_b_m + 1e-5);
    }
    // Walk up to the hit: within the cone's length the side of the mantle never changes.
    double last_u = -1.0, last_off = sign;
    for (double w = 0.0; w < end - 1e-3; w += end / 400.0) {
      const auto [off, u] = off_mantle(cone, at(ray, w));
      if (u > 0.001 && u < 0.999 && last_u > 0.001 && last_u < 0.999) {
        CHECK((off > -2e-4) == (last_off > -2e-4));
      }
      last_u = u;
      last_off = off;
    }
  }
  CHECK(hits > 1000);
}

TEST_CASE("rays from inside, along the axis and along a generator have their answers") {
  const PackedCone tube = packed(Cone{{0, 0, 0}, {0, 0, 4}, 0.5, 0.5, {}});
  CHECK(intersect({0, 0, 2, 1, 0, 0}, tube, 0.0, 100.0) == Approx(0.5));
  CHECK(intersect({0.25, 0, 2, -1, 0, 0}, tube, 0.0, 100.0) == Approx(0.75));
  CHECK(intersect({0.2, 0.1, -3, 0, 0, 1}, tube, 0.0, 100.0) == kNoHit);
  CHECK(intersect({2, 0, -3, 0, 0, 1}, tube, 0.0, 100.0) == kNoHit);
  const PackedCone tip = packed(Cone{{0, 0, 0}, {0, 0, 1}, 1.0, 0.0, {}});
  CHECK(intersect({0.5, 0, -1, 0, 0, 1}, tip, 0.0, 100.0) == Approx(1.5));
  // Parallel to the generator x + z = 1, half a metre below it: the far side is met.
  const double w = std::sqrt(0.5);
  CHECK(intersect({2, 0, -1.5, -w, 0, w}, tip, 0.0, 100.0) == Approx(2.25 / w).epsilon(1e-6));
  CHECK(intersect({3, 0, 0.5, -1, 0, 0}, tip, 0.0, 100.0) == Approx(2.5));
  CHECK(intersect({3, 0, 0.5, -1, 0, 0}, tip, 0.0, 2.0) == kNoHit);
  CHECK(intersect({3, 0, 0.5, -1, 0, 0}, tip, 2.6, 100.0) == Approx(3.5));
  // A cone without length has no mantle.
  CHECK(intersect({3, 0, 0, -1, 0, 0}, packed(Cone{{0, 0, 0}, {0, 0, 0}, 1, 1, {}}), 0.0, 100.0) ==
        kNoHit);
}

TEST_CASE("no ray slips between chained cones, straight or bent by two degrees") {
  for (const double bend : {0.0, 0.035}) {
    const Eigen::Vector3d a(0, 0, 0), b(0, 0, 1.3), c(std::sin(bend), 0, 1.3 + std::cos(bend));
    const PackedCone low = packed(Cone{a, b, 0.15, 0.14, {}}),
                     high = packed(Cone{b, c, 0.14, 0.13, {}});
    for (int i = 0; i < 20000; ++i) {
      RandomStream s(9, "joint", {static_cast<std::uint64_t>(i)});
      const double around = s.uniform(0.0, 2.0 * M_PI);
      const Eigen::Vector3d from(10 * std::cos(around), 10 * std::sin(around), s.uniform(0.5, 2.5));
      const Ray ray = towards(from, {0, 0, 1.3 + s.uniform(-0.006, 0.006)});
      const double t = std::min(intersect(ray, low, 0, 100), intersect(ray, high, 0, 100));
      REQUIRE(std::fabs(t * std::hypot(ray.dx, ray.dy) - 9.86) < 0.02);
    }
  }
}

TEST_CASE("cutting a cone into pieces leaves its surface as it was") {
  const Cone branch = {{1, 2, 3}, {2.5, 3.5, 4}, 0.03, 0.005, {4, Part::kBranch}};
  const ConePieces pieces = cut_into_pieces({branch}, 0.3);
  REQUIRE(pieces.cones.size() == 5);
  for (std::uint64_t i = 0; i < 5000; ++i) {
    RandomStream s(5, "pieces", {i});
    const Ray ray =
        towards(random_point(s, 10.0),
                branch.a_m + s.uniform() * (branch.b_m - branch.a_m) + random_point(s, 0.02));
    const double whole = intersect(ray, packed(branch), 0.0, 100.0);
    double least = kNoHit;
    for (const PackedCone& piece : pieces.cones) {
      const double t = intersect(ray, piece, 0.0, 100.0);
      least = std::min(least, t);
      if (t == kNoHit) continue;
      const Box box = bounds(piece);
      const Eigen::Vector3f p = at(ray, t).cast<float>();
      CHECK(((p - box.low).minCoeff() >= 0.0F && (box.high - p).minCoeff() >= 0.0F));
    }
    // Grazing rays may fall to either side by the rounding of the corners.
    if (whole != kNoHit && least != kNoHit) CHECK(std::fabs(whole - least) < 2e-3);
  }
}

TEST_CASE("an ellipsoid answers along its turned axes, from outside and from inside") {
  const double yaw = 0.3;
  const PackedEllipsoid e = packed(Ellipsoid{{5, 1, 2}, {2.0, 0.5, 1.0}, yaw, {}});
  const Eigen::Vector3d centre(5, 1, 2), axis(std::cos(yaw), std::sin(yaw), 0);
  CHECK(intersect(towards(centre - 10.0 * axis, centre), e, 0, 100) == Approx(8.0));
  CHECK(intersect(towards(centre, centre + axis), e, 0, 100) == Approx(2.0));
  CHECK(intersect(towards(centre + Eigen::Vector3d(0, 0, 9), centre), e, 0, 100) == Approx(8.0));
  CHECK(intersect(towards(centre + Eigen::Vector3d(0, 0, 9), centre), e, 8.5, 100) == Approx(10.0));
  CHECK(intersect(towards({0, 0, 9}, {0, 1, 9}), e, 0, 100) == kNoHit);
  CHECK(incidence_cosine(towards(centre - 10.0 * axis, centre), e, 8.0) == Approx(1.0));
}

TEST_CASE("incidence on a cone is measured against its slanted mantle") {
  // A right circular cone of 45 degrees: a horizontal ray meets it under 45 degrees.
  const PackedCone tip = packed(Cone{{0, 0, 0}, {0, 0, 1}, 1.0, 0.0, {}});
  const Ray ray = {3, 0, 0.5, -1, 0, 0};
  CHECK(incidence_cosine(ray, tip, 2.5) == Approx(std::sqrt(0.5)));
  const PackedCone tube = packed(Cone{{0, 0, 0}, {0, 0, 4}, 0.5, 0.5, {}});
  const Ray off_centre = {3, 0.25, 2, -1, 0, 0};
  CHECK(incidence_cosine(off_centre, tube, 3.0 - 0.5 * std::cos(M_PI / 6)) ==
        Approx(std::cos(M_PI / 6)));
}

}  // namespace honka::sim
