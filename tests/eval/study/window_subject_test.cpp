// Windows of a shared forest: where they are drawn, what they share, and what moves their digits.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "algo/types/user_error.h"
#include "eval/run/drawn_window.h"
#include "eval/study/subject.h"
#include "eval/study/subjects/recent.h"
#include "tests/eval/study/small_studies.h"

using namespace honka;
using namespace honka::eval;

namespace {

Pose3 first_pose(const DrawnWindow& window) {
  return window.drive.key_frames.front().T_world_lidar;
}

/// The values of one trial that are no times.
std::vector<double> digits_of_window(const std::vector<std::string>& overrides) {
  const Scenario scenario = test::small_study("localization", overrides);
  std::vector<double> digits;
  for (const StudyKind& kind : study_kinds()) {
    if (kind.experiment != "localization") continue;
    const auto results = kind.make(scenario)->run(0);
    for (std::size_t k = 0; k < kind.measures.size(); ++k) {
      const double value = results.back().values[k];
      if (kind.measures[k].kind != MeasureKind::kTime) {
        digits.push_back(std::isnan(value) ? -1.0 : value);
      }
    }
  }
  return digits;
}

}  // namespace

TEST_CASE("a drawn window has so many key frames, and no other sweep was cast") {
  const Scenario scenario = test::small_study("localization", {"protocol.window_frames=5"});
  const TrialWorld world = make_trial_world(scenario, 0);
  std::set<std::pair<double, double>> places;
  int ahead = 0;
  for (std::int64_t draw = 0; draw < 8; ++draw) {
    const DrawnWindow window = draw_window(scenario, world, 5, draw);
    REQUIRE(window.drive.key_frames.size() == 5);
    REQUIRE(window.scans.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
      REQUIRE(window.scans[k].size() == 1);
      CHECK(window.scans[k][0].index == window.drive.key_frames[k].sweeps[0].index);
      CHECK(window.scans[k][0].returns.size() > 1000);
      if (k == 0) continue;
      const double step_m = (window.drive.key_frames[k].T_odom_lidar.translation() -
                             window.drive.key_frames[k - 1].T_odom_lidar.translation())
                                .norm();
      CHECK(step_m >= 0.3 - 1e-6);
      CHECK(step_m < 0.3 + 0.1 + 0.06);  // a sweep's way late, and the odometry's jitter
    }
    const Eigen::Vector3d place = first_pose(window).translation();
    places.insert({place.x(), place.y()});
    CHECK(sim::distance_m(world.work_path, place.head<2>()) < 3.0);
    const Eigen::Vector2d way = world.work_path.back() - world.work_path.front();
    if (way.dot(first_pose(window).linear().col(0).head<2>()) > 0.0) ++ahead;
  }
  CHECK(places.size() == 8);
  CHECK(ahead > 0);
  CHECK(ahead < 8);
}

TEST_CASE("points that differ in a noise have windows at the same true places") {
  const Scenario base = test::small_study("localization");
  const TrialWorld world = make_trial_world(base, 1);
  for (const char* key :
       {"lidar.range_noise_m=0.1", "lidar.model=\"hdl32\"", "stems.voxel_m=0.1"}) {
    CAPTURE(key);
    const Scenario other = test::small_study("localization", {key});
    const TrialWorld other_world = make_trial_world(other, 1);
    REQUIRE(other_world.stand.trees.size() == world.stand.trees.size());
    CHECK(other_world.stand.trees.back().base_m == world.stand.trees.back().base_m);
    CHECK(first_pose(draw_window(base, world, 2, 1)).matrix() ==
          first_pose(draw_window(other, other_world, 2, 1)).matrix());
  }
}

TEST_CASE("every key of the sensor, the odometry and the map moves the digits of a window") {
  const auto key = GENERATE(as<std::string>(), "lidar.range_noise_m=0.1", "lidar.model=\"os64\"",
                            "lidar.field_of_view_deg=120.0", "odometry.drift_deg=20.0",
                            "map.inventory.position_error_m=0.1", "protocol.window_frames=1");
  CAPTURE(key);
  static const std::vector<double> plain = digits_of_window({});
  CHECK(digits_of_window({key}) != plain);
}

TEST_CASE("every key of the forest moves the digits of a window") {
  const auto key = GENERATE(as<std::string>(), "forest.undergrowth.saplings_per_ha=2000.0",
                            "forest.terrain.relief_m=15.0", "forest.terrain.slope_deg=20.0",
                            "forest.spacing.process=\"rows\"", "forest.density_per_ha=900.0",
                            "map.thinned_to_per_ha=300.0");
  CAPTURE(key);
  static const std::vector<double> plain = digits_of_window({});
  CHECK(digits_of_window({key}) != plain);
}

TEST_CASE("a map may come from a run of its own, made once a world") {
  const std::vector<double> digits =
      digits_of_window({"map.source=\"prior_run\"", "map.strip_road_spacing_m=60.0",
                        "frame.distance_m=1.5", "protocol.path_length_m=40.0"});
  CHECK(digits[0] + digits[1] + digits[2] == 1.0);  // right, wrong or refused
  CHECK(digits[6] > 10.0);                          // stems in the window
  CHECK(digits[0] == 1.0);
}

TEST_CASE("a path too short for a window is the user's mistake, as is a map of no run before") {
  const Scenario scenario = test::small_study("localization", {"protocol.path_length_m=5.0"});
  const TrialWorld world = make_trial_world(scenario, 0);
  CHECK_THROWS_AS(draw_window(scenario, world, 2, 0), UserError);
  CHECK_THROWS_WITH(digits_of_window({"map.source=\"same_run\""}), Catch::Contains("prior_run"));
}

TEST_CASE("of things that were made the last few are kept") {
  Recent<int> recent(2);
  int made = 0;
  const auto get = [&](const std::string& key) {
    return *recent.get(key, [&] { return std::make_shared<const int>(++made); });
  };
  CHECK(get("a") == 1);
  CHECK(get("b") == 2);
  CHECK(get("a") == 1);  // and is now the latest
  CHECK(get("c") == 3);
  CHECK(get("a") == 1);
  CHECK(get("b") == 4);
  CHECK_THROWS(recent.get("d", []() -> std::shared_ptr<const int> { throw UserError("no"); }));
  CHECK(get("b") == 4);
}
