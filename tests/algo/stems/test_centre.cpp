#include <catch2/catch.hpp>

#include "algo/stems/centre.h"
#include "algo/types/angles.h"
#include "algo/types/random.h"

using namespace honka;

namespace {

/// `count` beams spread over the near side of a circle seen along `ray`, range noise `sigma_m`.
std::vector<SeenPoint> near_side(const Circle& circle, const Eigen::Vector2d& ray, int count,
                                 double sigma_m, RandomStream& random) {
  std::vector<SeenPoint> points;
  for (int k = 0; k < count; ++k) {
    const double u = random.uniform(-1.0, 1.0);
    const Eigen::Vector2d side(-ray.y(), ray.x());
    const double depth_m = circle.radius_m * std::sqrt(1.0 - u * u) + random.normal(0.0, sigma_m);
    points.push_back({circle.centre_m + circle.radius_m * u * side - depth_m * ray, ray});
  }
  return points;
}

}  // namespace

TEST_CASE("under noise the corrected centres beat the mean, which is biased by π/4 r") {
  RandomStream random(5, "centres");
  const Circle truth{{12.0, -7.0}, 0.13};
  const Eigen::Vector2d ray = truth.centre_m.normalized();
  double mean_bias = 0.0, corrected_square = 0.0, fit_square = 0.0, radius_sum = 0.0;
  int fits = 0;
  const int trials = 300;
  for (int trial = 0; trial < trials; ++trial) {
    const auto points = near_side(truth, ray, 80, 0.01, random);
    mean_bias += ray.dot(mean_of(points) - truth.centre_m) / trials;
    corrected_square += (bias_corrected(points).centre_m - truth.centre_m).squaredNorm() / trials;
    if (const auto fit = circle_fit(points)) {
      fit_square += (fit->centre_m - truth.centre_m).squaredNorm();
      radius_sum += fit->radius_m;
      ++fits;
    }
  }
  CHECK(mean_bias == Approx(-kPi / 4.0 * truth.radius_m).epsilon(0.02));
  CHECK(std::sqrt(corrected_square) < 0.02);
  REQUIRE(fits > 290);
  CHECK(std::sqrt(fit_square / fits) < 0.01);
  CHECK(radius_sum / fits == Approx(truth.radius_m).epsilon(0.05));
}

TEST_CASE("a branch does not pull the fit away, and widens the stem by less than half") {
  RandomStream random(6, "branches");
  const Circle truth{{10.0, 0.0}, 0.15};
  auto points = near_side(truth, {1.0, 0.0}, 100, 0.005, random);
  for (int k = 0; k < 25; ++k) {
    points.push_back({truth.centre_m + Eigen::Vector2d(-0.1, 0.2 + 0.01 * k), {1.0, 0.0}});
  }
  const auto fit = circle_fit(points);
  REQUIRE(fit);
  CHECK((fit->centre_m - truth.centre_m).norm() < 0.01);
  CHECK(bias_corrected(points).radius_m == Approx(truth.radius_m).epsilon(0.45));
}

TEST_CASE("no circle where the points do not show one") {
  RandomStream random(7, "no_circle");
  std::vector<SeenPoint> line, bush, few;
  for (int k = 0; k < 40; ++k) {
    line.push_back({{10.0, 0.01 * k}, {1.0, 0.0}});
    const double x = random.uniform(9.5, 10.5), y = random.uniform(-0.5, 0.5);
    bush.push_back({{x, y}, {1.0, 0.0}});
  }
  few = near_side({{10.0, 0.0}, 0.1}, {1.0, 0.0}, 7, 0.0, random);
  CHECK_FALSE(circle_fit(line));
  CHECK_FALSE(circle_fit(bush));
  CHECK_FALSE(circle_fit(few));
  // A hollow, seen from inside: its centre lies before the points.
  std::vector<SeenPoint> hollow = near_side({{10.0, 0.0}, 0.2}, {1.0, 0.0}, 60, 0.0, random);
  for (SeenPoint& p : hollow) p.ray = {-1.0, 0.0};
  CHECK_FALSE(circle_fit(hollow));
}

TEST_CASE("rays from all sides leave the mean where it is") {
  std::vector<SeenPoint> points;
  for (int k = 0; k < 64; ++k) {
    const Eigen::Vector2d out(std::cos(2.0 * kPi * k / 64), std::sin(2.0 * kPi * k / 64));
    points.push_back({Eigen::Vector2d(3.0, 4.0) + 0.2 * out, -out});
  }
  CHECK((bias_corrected(points).centre_m - Eigen::Vector2d(3.0, 4.0)).norm() < 1e-12);
  const auto fit = circle_fit(points);
  REQUIRE(fit);
  CHECK(fit->radius_m == Approx(0.2));
}
