#include "eval/run/odometry_trial.h"

#include <catch2/catch.hpp>

#include "eval/run/odometry_rows.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// 60 m × 60 m of bare stems, a drive of 12 m without stops.
Scenario small_stand() {
  Scenario scenario;
  scenario.forest.width_m = scenario.forest.length_m = 60.0;
  scenario.forest.crown.branches = scenario.forest.crown.foliage = false;
  scenario.forest.undergrowth.bushes_per_ha = 0.0;
  scenario.map.strip_road_spacing_m = 30.0;
  scenario.harvester.work_cycle = false;
  scenario.protocol.path_length_m = 12.0;
  return scenario;
}

std::string digest_of_runs(const std::vector<OdometryRun>& runs) {
  Table sweeps = odometry_sweep_table();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    append_odometry_sweeps(sweeps, static_cast<std::int64_t>(i), runs[i]);
  }
  return results_digest({&sweeps});
}

}  // namespace

TEST_CASE("every odometry takes each sweep once, with the same digits on any number of threads") {
  const Scenario scenario = small_stand();
  const NamedStand stand = stands_of(scenario).front();
  const auto runs = run_odometry_trial(scenario, stand, 0, 1, "small");
  REQUIRE(runs.size() == odometry_names().size());
  for (const OdometryRun& run : runs) {
    CAPTURE(run.odometry);
    CHECK(run.stand == "default");
    CHECK(run.estimates.size() == run.pairs.poses.size());
    CHECK(run.times_ms.size() == run.pairs.poses.size());
    CHECK(run.driven_m.back() == Approx(12.0).margin(0.2));
    for (std::size_t i = 0; i < run.estimates.size(); ++i) {
      CHECK(run.estimates[i].sweep == static_cast<std::int64_t>(i));
      CHECK(run.pairs.poses[i].estimate.matrix().allFinite());
    }
  }
  CHECK(digest_of_runs(run_odometry_trial(scenario, stand, 0, 2, "small")) == digest_of_runs(runs));
}

TEST_CASE("one odometry alone makes the run that it makes beside the others") {
  Scenario scenario = small_stand();
  scenario.protocol.path_length_m = 5.0;
  const NamedStand stand = stands_of(scenario).front();
  const auto both = run_odometry_trial(scenario, stand, 0, 2, "small");
  scenario.stands.odometries = "stems";
  const auto alone = run_odometry_trial(scenario, stand, 0, 2, "small");
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].odometry == both[1].odometry);
  CHECK(digest_of_runs(alone) == digest_of_runs({both[1]}));
}

TEST_CASE("each stand differs from the scenario's forest by its own keys") {
  Scenario scenario = small_stand();
  scenario.stands.path_length_m = 20.0;
  const auto stands = stands_of(scenario);
  std::vector<std::string> names;
  for (const NamedStand& stand : stands) names.push_back(stand.name);
  CHECK(names == std::vector<std::string>{"default", "open", "dense", "thinned", "undergrowth_rich",
                                          "steep"});
  const auto trees = [&](std::size_t i) {
    return make_stand_world(scenario, stands[i], 0).stand.trees.size();
  };
  CHECK(trees(0) == 132);  // 367/ha on 0.36 ha
  CHECK(trees(1) == 36);
  CHECK(trees(2) == 288);
  CHECK(trees(3) <= 57);  // the strip roads of a thinning take their own share
  CHECK(stands[0].path_length_m == 12.0);
  CHECK(stands[1].path_length_m == scenario.stands.path_length_m);
  CHECK(stands[4].forest.undergrowth.bushes_per_ha == 1500.0);
  CHECK(make_stand_world(scenario, stands[5], 0).stand.terrain.relief_m() >
        60.0 * std::tan(deg_to_rad(15.0)));
  scenario.stands.dense.run = false;
  CHECK(stands_of(scenario).size() == 5);
}
