#include <catch2/catch.hpp>

#include "algo/types/user_error.h"
#include "sim/forest/spacing/registry.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

SpacingDomain domain_of(double width, double length, std::int64_t count) {
  SpacingDomain domain;
  domain.box_m = {Vector2d::Zero(), Vector2d(width, length)};
  domain.count = count;
  domain.spacing_m = std::sqrt(width * length / static_cast<double>(count));
  return domain;
}

SpacingSettings chosen(const std::string& process) {
  SpacingSettings settings;
  settings.process = process;
  return settings;
}

double least_distance_m(const Points& points) {
  double best = 1e9;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) best = std::min(best, (points[i] - points[j]).norm());
  }
  return best;
}

}  // namespace

TEST_CASE("every process places exactly the asked stems on free ground") {
  const auto process = GENERATE(from_range(spacing_process_names()));
  const auto count = GENERATE(1, 2, 37, 400);
  CAPTURE(process, count);
  SpacingDomain domain = domain_of(80, 60, count);
  domain.corridors = CorridorMask({{{0, 30}, {80, 30}}, {{10, 0}, {40, 60}}}, 2.25, domain.box_m);
  domain.window_m = {Vector2d(50, 35), Vector2d(70, 50)};
  const Points points = place_stems(chosen(process), domain, 5);
  REQUIRE(points.size() == static_cast<std::size_t>(count));
  for (const auto& point : points) {
    CHECK(domain.box_m.contains(point));
    CHECK_FALSE(domain.window_m.contains(point));
    CHECK(std::abs(point.y() - 30.0) >= 2.25);
    CHECK(distance_to_segment_m(point, {10, 0}, {40, 60}) >= 2.25);
  }
}

TEST_CASE("every process gives the same digits for the same seed and others for another") {
  const auto process = GENERATE(from_range(spacing_process_names()));
  CAPTURE(process);
  const SpacingDomain domain = domain_of(50, 50, 120);
  CHECK(place_stems(chosen(process), domain, 1) == place_stems(chosen(process), domain, 1));
  CHECK(place_stems(chosen(process), domain, 1) != place_stems(chosen(process), domain, 2));
}

TEST_CASE("hard cores hold, to fixed stems too") {
  SpacingDomain domain = domain_of(50, 50, 150);
  for (int i = 0; i < 5; ++i) domain.fixed_m.emplace_back(5.0 + 10.0 * i, 25.0);
  Points points = place_stems(chosen("hard_core"), domain, 3);
  points.insert(points.end(), domain.fixed_m.begin(), domain.fixed_m.end());
  CHECK(least_distance_m(points) >= 0.33 * domain.spacing_m);
  Points soft = place_stems(chosen("strauss"), domain, 3);
  soft.insert(soft.end(), domain.fixed_m.begin(), domain.fixed_m.end());
  CHECK(least_distance_m(soft) >= 0.08 * domain.spacing_m);
}

TEST_CASE("fixed stems keep soft-core neighbours away") {
  // Around 100 fixed stems there are fewer others within 0.3 s than chance would put there.
  SpacingDomain domain = domain_of(200, 200, 1500);
  for (int i = 0; i < 100; ++i) domain.fixed_m.emplace_back(10 + 20 * (i % 10), 10 + 20 * (i / 10));
  const double reach_m = 0.3 * domain.spacing_m;
  int near = 0;
  for (const auto& point : place_stems(chosen("strauss"), domain, 9)) {
    for (const auto& fixed : domain.fixed_m) near += (point - fixed).norm() < reach_m ? 1 : 0;
  }
  const double by_chance = 100.0 * 3.1416 * 0.09;
  CHECK(near < 0.45 * by_chance);
}

TEST_CASE("a density that cannot be reached says so and ends") {
  SpacingSettings settings = chosen("hard_core");
  std::get<HardCore>(settings.processes).core = 0.95;
  CHECK_THROWS_AS(place_stems(settings, domain_of(60, 60, 300), 1), honka::UserError);
  settings = chosen("strauss");
  std::get<Strauss>(settings.processes) = {{0.99}, {0.0}, 20};
  CHECK_THROWS_WITH(place_stems(settings, domain_of(60, 60, 300), 1),
                    Catch::Contains("lower forest.density_per_ha"));
  settings = chosen("patchy");
  std::get<Patchy>(settings.processes) = {1.0, 0.1, 1.0, 0.5};
  CHECK_THROWS_AS(place_stems(settings, domain_of(60, 60, 300), 1), honka::UserError);
}

TEST_CASE("settings that make no sense are the user's mistake") {
  CHECK_THROWS_WITH(place_stems(chosen("strausss"), domain_of(9, 9, 3), 1),
                    Catch::Contains("strausss"));
  SpacingSettings settings = chosen("strauss");
  std::get<Strauss>(settings.processes).factors.pop_back();
  CHECK_THROWS_AS(place_stems(settings, domain_of(9, 9, 3), 1), honka::UserError);
  SpacingDomain closed = domain_of(9, 9, 3);
  closed.window_m = {Vector2d(-1, -1), Vector2d(10, 10)};
  for (const auto& process : spacing_process_names()) {
    CHECK_THROWS_AS(place_stems(chosen(process), closed, 1), honka::UserError);
  }
}
