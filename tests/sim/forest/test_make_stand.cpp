#include <catch2/catch.hpp>

#include "algo/types/angles.h"
#include "algo/types/user_error.h"
#include "sim/forest/forest.h"

using namespace honka::sim;
using Eigen::Vector2d;

namespace {

bool same(const Stand& a, const Stand& b) {
  if (a.trees.size() != b.trees.size() || a.rocks.size() != b.rocks.size()) return false;
  for (std::size_t i = 0; i < a.trees.size(); ++i) {
    const Tree &s = a.trees[i], &t = b.trees[i];
    if (s.base_m != t.base_m || s.dbh_m != t.dbh_m || s.height_m != t.height_m) return false;
    if (s.lean != t.lean || s.crown_base_m != t.crown_base_m) return false;
  }
  return a.bushes.size() == b.bushes.size() && a.logs.size() == b.logs.size();
}

ForestSettings small() {
  ForestSettings settings;
  settings.width_m = 80.0;
  settings.length_m = 60.0;
  return settings;
}

double distance_to(const Polyline& line, const Vector2d& point) {
  double best = 1e9;
  for (std::size_t i = 1; i < line.size(); ++i) {
    best = std::min(best, distance_to_segment_m(point, line[i - 1], line[i]));
  }
  return best;
}

}  // namespace

TEST_CASE("the default stand holds the paper's number of trees on its ground", "[Li2020]") {
  const Stand stand = make_stand({}, {}, 1);
  CHECK(stand.trees.size() == 2202);
  for (std::size_t i = 0; i < stand.trees.size(); ++i) {
    const Tree& tree = stand.trees[i];
    const Vector2d place = tree.base_m.head<2>();
    CHECK(tree.id == static_cast<std::int32_t>(i));
    CHECK(stand.extent_m.contains(place));
    CHECK(tree.base_m.z() == stand.terrain.height_m(place));
    CHECK(tree.height_m > 1.3);
    CHECK(tree.crown_base_m >= 0.5 * tree.height_m);
    CHECK(tree.crown_base_m <= 0.6 * tree.height_m);
  }
}

TEST_CASE("the same seed gives the same stand, another seed another") {
  const std::vector<Polyline> road = {{{0, 30}, {80, 30}}};
  CHECK(same(make_stand(small(), road, 1), make_stand(small(), road, 1)));
  CHECK_FALSE(same(make_stand(small(), road, 1), make_stand(small(), road, 2)));
}

TEST_CASE("diameters, heights and leans follow their laws") {
  ForestSettings settings;
  settings.spacing.process = "poisson";
  settings.density_per_ha = 1000.0;
  const Stand stand = make_stand(settings, {}, 3);
  const auto n = static_cast<double>(stand.trees.size());
  double dbh = 0, dbh2 = 0, lean2 = 0, residual = 0, residual2 = 0;
  for (const Tree& tree : stand.trees) {
    dbh += tree.dbh_m / n;
    dbh2 += tree.dbh_m * tree.dbh_m / n;
    lean2 += tree.lean.squaredNorm() / (2.0 * n);
    const double off = tree.height_m - naslund_height_m(settings.trees, tree.dbh_m);
    residual += off / n;
    residual2 += off * off / n;
  }
  const double shape = settings.trees.dbh_shape;
  const double mean = settings.trees.dbh_scale_m * std::tgamma(1.0 + 1.0 / shape);
  CHECK(dbh == Approx(mean).epsilon(0.01));
  CHECK(honka::sim::weibull_shape_of_variation(std::sqrt(dbh2 - dbh * dbh) / dbh) ==
        Approx(shape).epsilon(0.05));
  CHECK(std::sqrt(lean2) == Approx(std::tan(honka::deg_to_rad(1.5))).epsilon(0.03));
  CHECK(residual == Approx(0.0).margin(0.1));
  CHECK(std::sqrt(residual2) == Approx(2.0).epsilon(0.05));
}

TEST_CASE("a pine of 20 cm is as tall as Naslund's curve says") {
  // 1.3 + 400 / (1.3 + 0.19 · 20)² = 1.3 + 400 / 26.01.
  CHECK(naslund_height_m({}, 0.2) == Approx(16.6787).epsilon(1e-5));
}

TEST_CASE("corridors stay open for stems, bushes, rocks and logs, and the count is kept") {
  ForestSettings settings = small();
  settings.undergrowth.bushes_per_ha = 2000.0;
  settings.undergrowth.log_piles_per_100_m = 40.0;
  const Polyline road = {{-10, 20}, {30, 22}, {60, 45}, {90, 45}};
  const Polyline crossing = {{45, 0}, {45, 60}};
  const Stand stand = make_stand(settings, {road, crossing}, 8);
  CHECK(stand.trees.size() == 176);
  const double half = settings.corridor_half_width_m;
  for (const Tree& tree : stand.trees) {
    CHECK(distance_to(road, tree.base_m.head<2>()) >= half);
  }
  for (const Bush& bush : stand.bushes) CHECK(distance_to(road, bush.base_m.head<2>()) >= half);
  for (const auto& rock : stand.rocks) CHECK(distance_to(road, rock.centre_m.head<2>()) >= half);
  REQUIRE(stand.logs.size() > 10);
  for (const Log& log : stand.logs) {
    CHECK(distance_to(road, log.a_m.head<2>()) >= half);
    CHECK(distance_to(road, log.b_m.head<2>()) >= half);
    CHECK(distance_to(crossing, log.a_m.head<2>()) >= half);
    CHECK(distance_to(crossing, log.b_m.head<2>()) >= half);
  }
}

TEST_CASE("a margin continues the forest at the same density") {
  ForestSettings settings = small();
  settings.margin_m = 20.0;
  const Stand stand = make_stand(settings, {}, 2);
  CHECK(stand.trees.size() == 440);  // 367/ha on 120 m × 100 m
  int inside = 0;
  for (const Tree& tree : stand.trees)
    inside += stand.extent_m.contains(tree.base_m.head<2>().eval());
  CHECK(inside == Approx(176).margin(25));
}

TEST_CASE("settings that cannot be are the user's mistake") {
  const auto refuses = [](auto change) {
    ForestSettings settings = small();
    change(settings);
    CHECK_THROWS_AS(make_stand(settings, {}, 1), honka::UserError);
  };
  refuses([](ForestSettings& s) { s.density_per_ha = 0.0; });
  refuses([](ForestSettings& s) { s.width_m = -1.0; });
  refuses([](ForestSettings& s) { s.density_per_ha = 1e10; });
  refuses([](ForestSettings& s) { s.trees.crown_base_low = 0.9; });
  refuses([](ForestSettings& s) { s.spacing.process = "no such"; });
  ForestSettings wide = small();
  wide.corridor_half_width_m = 50.0;
  CHECK_THROWS_WITH(make_stand(wide, {{{0, 30}, {80, 30}}}, 1), Catch::Contains("corridors"));
}
