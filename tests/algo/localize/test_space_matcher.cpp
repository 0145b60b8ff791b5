// The matcher of stars in space on lists of tilted sensors.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/localize/li2020/li2020.h"
#include "algo/types/user_error.h"
#include "tests/support/space_world.h"

using namespace honka;
using namespace honka::test;

namespace {

LocalizeSettings space_settings(double tolerance_m2 = 4.5) {
  LocalizeSettings settings;
  settings.li2020.stars = "space";
  settings.li2020.tolerance_m2 = tolerance_m2;
  return settings;
}

Li2020MatcherIn<3> space_matcher(const SpacePoints& map, double tolerance_m2 = 4.5) {
  return {map, space_settings(tolerance_m2).li2020};
}

double gap_of(const LocateResult& answer, const Pose3& truth) {
  REQUIRE(answer.T_map_local_3d);
  return (answer.T_map_local_3d->matrix() - truth.matrix()).norm();
}

}  // namespace

TEST_CASE("Stars in space find a tilted list with its tilt, those in the plane do not") {
  const SpacePoints map = stems_on(rough_ground);
  const auto space = space_matcher(map, 1e-6);
  LocalizeSettings settings;
  settings.li2020.tolerance_m2 = 1e-6;
  const auto plane = create_matcher("li2020", map, settings);
  const double yaw = GENERATE(0.3, -2.8);
  const auto [roll_deg, pitch_deg] = GENERATE(std::pair(0.0, 0.0), std::pair(5.0, -12.0),
                                              std::pair(-20.0, 10.0), std::pair(0.0, 30.0));
  const Pose3 truth = tilted_pose(roll_deg, pitch_deg, yaw);
  const SpacePoints local = seen_in_space(map, truth);
  const LocateResult answer = space.locate(local);
  REQUIRE(answer.accepted());
  CHECK(gap_of(answer, truth) < 1e-9);
  CHECK((answer.T_map_local.translation_m - planar(truth).translation_m).norm() < 1e-9);
  CHECK(std::abs(wrap_to_pi(answer.T_map_local.yaw_rad - yaw)) < 1e-9);
  for (const StarMatch& match : answer.star_matches) {
    for (const VertexPair& pair : match.pairs) {
      const Eigen::Vector3d seen = truth * local[static_cast<std::size_t>(pair.local)];
      CHECK((seen - map[static_cast<std::size_t>(pair.map)]).norm() < 1e-9);
    }
  }
  const LocateResult in_plane = plane->locate(local);
  CHECK_FALSE(in_plane.T_map_local_3d);
  CHECK(in_plane.accepted() == (roll_deg == 0.0 && pitch_deg == 0.0));
}

TEST_CASE("A sensor along the ground of a plane slope shrinks every triangle of the map's plan") {
  // A slope of 25°: areas in plan are cos 25° of those that the list has, so that no triangle of
  // more than 0.1 m² is like itself within 0.001 m².
  const double slope_rad = deg_to_rad(25.0);
  const Pose3 T_map_ground = pose_from_rpy({40.0, 40.0, 5.0}, 0.0, -slope_rad, 0.0);
  SpacePoints map = stems_on(flat_ground);
  for (Eigen::Vector3d& p : map) p -= Eigen::Vector3d(40.0, 40.0, 0.0);
  map = moved_in_space(T_map_ground, map);
  const SpacePoints local = seen_in_space(map, T_map_ground);
  for (const Eigen::Vector3d& p : local) CHECK(std::abs(p.z()) < 1e-9);
  const LocateResult answer = space_matcher(map, 0.001).locate(local);
  REQUIRE(answer.accepted());
  CHECK(gap_of(answer, T_map_ground) < 1e-9);
  LocalizeSettings settings;
  settings.li2020.tolerance_m2 = 0.001;
  CHECK(create_matcher("li2020", map, settings)->locate(local).matches == 0);
}

TEST_CASE("Level and flat, both kinds of stars give one answer") {
  const SpacePoints map = stems_on(flat_ground);
  const Pose3 truth = pose_from_rpy({41.0, 38.0, 0.0}, 0.0, 0.0, 0.8);
  SpacePoints local = seen_in_space(map, truth);
  RandomStream random(2, "space_stars_noise");
  for (Eigen::Vector3d& p : local) p.x() += random.normal(0.0, 0.03);
  const LocateResult space = space_matcher(map).locate(local);
  const LocateResult plane = create_matcher("li2020", map, {})->locate(local);
  CHECK(space.matches == plane.matches);
  CHECK(space.candidates == plane.candidates);
  CHECK(space.agreeing == plane.agreeing);
  CHECK((space.T_map_local.translation_m - plane.T_map_local.translation_m).norm() < 0.1);
  CHECK(std::abs(wrap_to_pi(space.T_map_local.yaw_rad - plane.T_map_local.yaw_rad)) < 0.01);
}

TEST_CASE("Lists of mirrored stems and of another forest are refused in space, too") {
  const auto ground = GENERATE(flat_ground, rough_ground);
  const SpacePoints map = stems_on(ground);
  const Pose3 truth = tilted_pose(0.0, 0.0, 0.8);
  SpacePoints local = seen_in_space(map, truth);
  REQUIRE(space_matcher(map).locate(local).accepted());
  for (Eigen::Vector3d& p : local) p.y() = -p.y();  // on flat ground a motion: turned upside down
  CHECK(space_matcher(map).locate(local).verdict == Verdict::kNotInMap);
  const auto other = seen_in_space(stems_on(ground, 77), truth);
  CHECK(space_matcher(map).locate(other).verdict == Verdict::kNotInMap);
}

TEST_CASE("The order of lists with heights does not change a digit") {
  SpacePoints map = stems_on(rough_ground);
  SpacePoints local = seen_in_space(map, tilted_pose(8.0, -5.0, 0.8));
  RandomStream random(3, "space_stars_noise");
  for (Eigen::Vector3d& p : local) p.z() += random.normal(0.0, 0.1);
  const LocateResult a = space_matcher(map).locate(local);
  std::reverse(map.begin() + 5, map.end());
  std::rotate(local.begin(), local.begin() + 7, local.end());
  const LocateResult b = space_matcher(map).locate(local);
  REQUIRE(a.matches > 5);
  CHECK(a.matches == b.matches);
  CHECK(a.agreeing == b.agreeing);
  CHECK(a.cost_m == b.cost_m);
  CHECK(a.T_map_local_3d->matrix() == b.T_map_local_3d->matrix());
}

TEST_CASE("Priors, sub-maps and UTM-sized maps hold in space") {
  SpacePoints map = stems_on(rough_ground);
  const Pose3 truth = tilted_pose(10.0, -10.0, 2.0);
  const SpacePoints local = seen_in_space(map, truth);
  const auto matcher = space_matcher(map, 0.001);
  const Eigen::Vector2d place_m = truth.translation().head<2>();
  CHECK(gap_of(matcher.locate(local, LocatePrior{place_m, 1.0}), truth) < 1e-9);
  CHECK_FALSE(matcher.locate(local, LocatePrior{{5.0, 5.0}, 1.0}).accepted());
  LocalizeSettings tiled = space_settings(0.001);
  tiled.li2020.submap_size_m = 70.0;
  CHECK(gap_of(create_matcher("li2020", map, tiled)->locate(local), truth) < 1e-9);
  const Eigen::Vector3d utm(654321.0, 6912345.0, 210.0);
  for (Eigen::Vector3d& p : map) p += utm;
  const LocateResult far = space_matcher(map, 0.001).locate(local);
  REQUIRE(far.accepted());
  CHECK((far.T_map_local_3d->translation() - utm - truth.translation()).norm() < 1e-6);
  CHECK((far.T_map_local_3d->linear() - truth.linear()).norm() < 1e-8);
}

TEST_CASE("Heights that are missing or not finite are told of") {
  SpacePoints map = stems_on(rough_ground);
  const auto plan = plan_of(map);
  CHECK_THROWS_WITH(create_matcher("li2020", plan, space_settings()), Catch::Contains("z_m"));
  const auto space = create_matcher("li2020", map, space_settings());
  CHECK_THROWS_WITH(space->locate(plan), Catch::Contains("z_m"));
  LocalizeSettings bad = space_settings();
  bad.li2020.selection = GENERATE("box", "branch_and_bound");
  CHECK_THROWS_WITH(create_matcher("li2020", map, bad), Catch::Contains("candidates"));
  bad = {};
  bad.li2020.stars = "3d";
  CHECK_THROWS_WITH(create_matcher("li2020", map, bad), Catch::Contains("plane or space"));
  map[30].z() = GENERATE(NAN, INFINITY);
  for (const std::string& name : matcher_names()) {
    CHECK_THROWS_WITH(create_matcher(name, map, {}), Catch::Contains("stem 31 of 400"));
    const auto in_plane = create_matcher(name, plan, {});
    CHECK_THROWS_WITH(in_plane->locate(map), Catch::Contains("stem 31 of 400"));
  }
  CHECK_THROWS_WITH(space->locate(map), Catch::Contains("stem 31 of 400"));
  CHECK_THROWS_AS(create_matcher("li2020", map, space_settings()), UserError);
}

TEST_CASE("Matchers in the plane leave heights out") {
  const SpacePoints map = stems_on(rough_ground);
  const SpacePoints local = seen_in_space(map, tilted_pose(0.0, 0.0, 1.0));
  for (const std::string& name : matcher_names()) {
    const LocateResult with = create_matcher(name, map, {})->locate(local);
    const LocateResult without = create_matcher(name, plan_of(map), {})->locate(plan_of(local));
    CHECK(with.accepted());
    CHECK(with.T_map_local.translation_m == without.T_map_local.translation_m);
    CHECK(with.T_map_local.yaw_rad == without.T_map_local.yaw_rad);
  }
}
