// Rows on slopes: their lists against the stand, and against the rows on level ground.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "algo/localize/li2020/star.h"
#include "eval/run/localize/options_query.h"

using namespace honka;
using namespace honka::eval;

namespace {

Scenario small_options() {
  Scenario scenario;
  scenario.forest.width_m = scenario.forest.length_m = 120.0;
  scenario.options.queries = 20;
  scenario.options.list.noise_m = 0.0;
  scenario.options.height_noise_m = 0.0;
  scenario.map.sources.inventory.position_error_m = 0.0;
  scenario.map.sources.inventory.least_dbh_m = 0.0;
  scenario.variants.methods = "li2020, consensus";
  return scenario;
}

OptionsCase options_case(const Scenario& scenario, const std::string& name,
                         const std::string& method = "li2020") {
  for (const OptionsCase& one : options_cases(scenario)) {
    if (one.name == name && one.method == method) return one;
  }
  FAIL("no row " << name);
  return {};
}

int right_answers(const std::vector<OptionsAnswer>& answers) {
  int right = 0;
  for (const OptionsAnswer& a : answers) right += a.accepted && a.right ? 1 : 0;
  return right;
}

std::array<std::int32_t, 3> sorted_trees(const DelaunayTriangle& triangle,
                                         const std::vector<std::int32_t>& tree) {
  std::array<std::int32_t, 3> trees{};
  for (std::size_t k = 0; k < 3; ++k) {
    trees[k] = tree[static_cast<std::size_t>(triangle.vertices[k])];
  }
  std::sort(trees.begin(), trees.end());
  return trees;
}

/// Of the stars that perfect lists on a slope are matched by, those whose four triangles are the
/// map's.
double share_of_map_stars(const OptionsWorld& world, double slope_deg) {
  const sim::SlopedForest slope(world.forest, deg_to_rad(slope_deg));
  sim::SightingSettings perfect;
  perfect.noise_m = 0.0;
  std::vector<std::int32_t> itself(world.forest.trees_m.size());
  std::iota(itself.begin(), itself.end(), 0);
  std::set<std::array<std::int32_t, 3>> of_map;
  for (const DelaunayTriangle& t : build_delaunay(world.forest.trees_m).triangles) {
    of_map.insert(sorted_trees(t, itself));
  }
  double stars = 0.0, kept = 0.0;
  for (std::uint64_t q = 0; q < 100; ++q) {
    const Pose2 place = sim::draw_pose(world.forest, 30.0, 1, q);
    const auto list = sim::sight_on_slope(slope, place, perfect, 0.0, 1, q);
    const DelaunayGraph graph = build_delaunay(plan_of(list.stems_in_sensor_m));
    const auto is_of_map = [&](std::int32_t triangle) {
      return of_map.count(
                 sorted_trees(graph.triangles[static_cast<std::size_t>(triangle)], list.trees)) > 0;
    };
    for (const TriangleStar& star : stars_of(graph, StarChoice::kNoHullVertex)) {
      const auto& centre = graph.triangles[static_cast<std::size_t>(star.triangle)];
      stars += 1.0;
      kept += is_of_map(star.triangle) &&
              std::all_of(centre.neighbours.begin(), centre.neighbours.end(), is_of_map);
    }
  }
  return kept / stars;
}

}  // namespace

TEST_CASE("Every slope has its rows, and no other row has one") {
  Scenario scenario = small_options();
  scenario.options.slopes_deg = {15.0};
  for (const char* how : {"stars in the plane", "stars in space", "levelled"}) {
    const auto one = options_case(scenario, std::string("slope of 15°, ") + how);
    CHECK(one.slope_deg == 15.0);
    CHECK((one.settings.li2020.stars == "space") == (std::string(how) == "stars in space"));
    CHECK(one.levelled == (std::string(how) == "levelled"));
  }
  CHECK(options_case(scenario, "slope of 15°", "consensus").slope_deg == 15.0);
  scenario.options.slopes_deg = {};
  for (const OptionsCase& one : options_cases(scenario)) CHECK_FALSE(one.slope_deg);
}

TEST_CASE("Levelled lists lie in the map's plan, tilted ones in space") {
  const Scenario scenario = small_options();
  const OptionsWorld world = make_options_world(scenario, 0);
  const OptionsCase level = options_case(scenario, "slope of 20°, levelled");
  const OptionsCase space = options_case(scenario, "slope of 20°, stars in space");
  const OptionsQueries levelled(scenario, world, level), tilted(scenario, world, space);
  for (std::uint64_t q = 0; q < 5; ++q) {
    const OptionsQuery in_plan = levelled.query(q), in_space = tilted.query(q);
    REQUIRE(in_plan.stems_m.size() > 20);
    REQUIRE(in_plan.stems_m.size() == in_space.stems_m.size());
    CHECK_FALSE(in_plan.T_map_sensor_3d);
    CHECK(in_plan.T_map_sensor.translation_m == in_space.T_map_sensor.translation_m);
    for (std::size_t i = 0; i < in_plan.stems_m.size(); ++i) {
      const Eigen::Vector2d tree = in_plan.T_map_sensor * in_plan.stems_m[i].head<2>();
      const Eigen::Vector3d foot = *in_space.T_map_sensor_3d * in_space.stems_m[i];
      CHECK((foot.head<2>() - tree).norm() < 1e-9);
      CHECK(foot.z() == Approx(tree.x() * std::tan(deg_to_rad(20.0))).margin(1e-9));
      CHECK(world.forest.near->nearest(tree).value().distance_m < 1e-9);
    }
  }
}

// Not without any error: the map has stems at breast height, lists their feet.
TEST_CASE("Without noise a slope costs stars in the plane all, and level ground nothing") {
  const Scenario scenario = small_options();
  const OptionsWorld world = make_options_world(scenario, 0);
  const auto ask = [&](const std::string& name) {
    return answer_options(scenario, world, options_case(scenario, name), 1);
  };
  const auto literal = ask("literal"), flat = ask("slope of 0°, stars in the plane");
  REQUIRE(right_answers(literal) > 15);
  for (std::size_t q = 0; q < literal.size(); ++q) {
    CHECK(flat[q].error_m == Approx(literal[q].error_m).margin(1e-9));
    CHECK(flat[q].candidates == literal[q].candidates);
  }
  CHECK(right_answers(ask("slope of 20°, stars in the plane")) == 0);
  CHECK(right_answers(ask("slope of 20°, levelled")) > 15);
  const auto space = ask("slope of 20°, stars in space");
  CHECK(right_answers(space) > 10);
  for (const OptionsAnswer& a : space) {
    if (a.accepted) CHECK(a.tilt_error_deg.value() < 3.0);
  }
}

TEST_CASE(
    "The plan of a tilted sensor's list has fewer of the map's stars, the steeper the fewer") {
  const OptionsWorld world = make_options_world(Scenario(), 0);  // 200 m × 300 m
  double share = 1.0;
  for (const double slope_deg : {0.0, 10.0, 20.0, 30.0}) {
    const double steeper = share_of_map_stars(world, slope_deg);
    CHECK(steeper < share);
    share = steeper;
  }
  CHECK(share == Approx(0.52).margin(0.01));  // the README's, of the first stand
}
