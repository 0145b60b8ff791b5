#include "eval/run/drive.h"

#include <catch2/catch.hpp>

using namespace honka;
using namespace honka::eval;

namespace {

Scenario small_scenario(const std::string& odometry) {
  Scenario scenario;
  scenario.forest.width_m = 60.0;
  scenario.forest.length_m = 60.0;
  scenario.forest.crown.branches = false;
  scenario.forest.crown.foliage = false;
  scenario.forest.undergrowth.bushes_per_ha = 0.0;
  scenario.map.strip_road_spacing_m = 30.0;
  scenario.protocol.path_length_m = 8.0;
  scenario.harvester.work_cycle = false;
  scenario.odometry.source = odometry;
  return scenario;
}

struct Taken {
  Drive drive;
  std::vector<std::vector<std::int64_t>> sweeps;  ///< of each key frame, as they were handed over
  std::vector<std::size_t> returns;
};

Taken drive(const Scenario& scenario, const TrialWorld& world, int threads) {
  Taken taken;
  taken.drive =
      drive_and_scan(work_drive(scenario, world), scenario, world.seed, "test", threads,
                     [&](const KeyFrame& key_frame, std::vector<sim::TruthfulSweep>&& sweeps) {
                       REQUIRE(sweeps.size() == key_frame.sweeps.size());
                       taken.sweeps.emplace_back();
                       for (const auto& sweep : sweeps)
                         taken.sweeps.back().push_back(sweep.sweep.index);
                       taken.returns.push_back(sweeps.front().sweep.returns.size());
                     });
  return taken;
}

}  // namespace

TEST_CASE("every key frame comes once, in order, with the sweeps that it names") {
  const std::string odometry = GENERATE("truth+noise", "loam", "stems");
  Scenario scenario = small_scenario(odometry);
  scenario.frame.sweeps = GENERATE(1, 5);
  const TrialWorld world = make_trial_world(scenario, 0);
  const Taken taken = drive(scenario, world, 2);
  REQUIRE(taken.drive.key_frames.size() > 10);
  REQUIRE(taken.sweeps.size() == taken.drive.key_frames.size());
  for (std::size_t k = 0; k < taken.sweeps.size(); ++k) {
    const KeyFrame& key_frame = taken.drive.key_frames[k];
    REQUIRE(taken.sweeps[k].size() == static_cast<std::size_t>(scenario.frame.sweeps));
    CHECK(taken.returns[k] > 0);
    for (std::size_t i = 0; i < taken.sweeps[k].size(); ++i) {
      CHECK(taken.sweeps[k][i] == key_frame.sweeps[i].index);
      if (i > 0) CHECK(taken.sweeps[k][i] == taken.sweeps[k][i - 1] + 1);
    }
    if (k > 0) CHECK(key_frame.time_s > taken.drive.key_frames[k - 1].time_s);
  }
}

TEST_CASE("the odometry's frame is laid onto the world, truth and noise stand there already") {
  const std::string odometry = GENERATE("truth+noise", "loam", "stems");
  const Scenario scenario = small_scenario(odometry);
  const TrialWorld world = make_trial_world(scenario, 0);
  const Drive drive = ::drive(scenario, world, 2).drive;
  const Pose3 first = drive.key_frames.front().T_odom_lidar;
  if (odometry == "truth+noise") {
    CHECK(drive.T_world_odom.isApprox(Pose3::Identity(), 0.0));
  } else {
    CHECK(first.translation().norm() < 0.1);  // a lidar odometry begins at its own origin
  }
  for (const KeyFrame& key_frame : drive.key_frames) {
    const Pose3 estimate = drive.T_world_odom * key_frame.T_odom_lidar;
    CHECK((estimate.translation() - key_frame.T_world_lidar.translation()).norm() < 0.5);
  }
}

TEST_CASE("a drive has the same digits on any number of threads") {
  const std::string odometry = GENERATE("truth+noise", "loam", "stems");
  const Scenario scenario = small_scenario(odometry);
  const TrialWorld world = make_trial_world(scenario, 0);
  const Taken one = drive(scenario, world, 1), three = drive(scenario, world, 3);
  REQUIRE(one.drive.key_frames.size() == three.drive.key_frames.size());
  for (std::size_t k = 0; k < one.drive.key_frames.size(); ++k) {
    CHECK((one.drive.key_frames[k].T_odom_lidar.matrix().array() ==
           three.drive.key_frames[k].T_odom_lidar.matrix().array())
              .all());
  }
}

TEST_CASE("a thinning between the runs takes trees from the second alone") {
  Scenario scenario = small_scenario("truth+noise");
  const TrialWorld whole = make_trial_world(scenario, 0);
  CHECK_FALSE(whole.before_thinning.has_value());
  scenario.map.thinned_to_per_ha = 150.0;
  const TrialWorld thinned = make_trial_world(scenario, 0);
  CHECK(thinned.when_mapped().stand.trees.size() == whole.stand.trees.size());
  CHECK(thinned.stand.trees.size() < whole.stand.trees.size());
  CHECK(prior_drive(scenario, thinned).stand == &thinned.when_mapped());
}
