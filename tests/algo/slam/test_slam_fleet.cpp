// Several vehicles in one map: found without a guess, adjusted together, left apart where apart.
#include <catch2/catch.hpp>

#include "algo/slam/chain.h"
#include "algo/slam/fleet.h"
#include "tests/algo/slam/methods_world.h"

namespace {

using namespace honka;
using namespace honka::test;

/// Two drives over stretches of one track that share their middle; the second comes back turned by
/// half a circle, and knows nothing of the first.
struct TwoDrives {
  MethodsWorld world = methods_world(120, 0.03);
  std::vector<VehicleDrive> drives;
  FramePoses truth;  ///< of all frames, in the first frame of the first drive

  TwoDrives() {
    drives.resize(2);
    const Pose3 turned = pose_from_rpy({0.0, 0.0, 0.0}, 0.0, 0.0, kPi);
    for (std::size_t l = 0; l < 70; ++l) {
      drives[0].frames.push_back(world.frames[l]);
      truth.push_back(world.T_first_frame[l]);
    }
    for (std::size_t l = 119; l >= 50; --l) {
      SparseFrame frame{static_cast<std::int64_t>(119 - l), {}};
      for (const auto& point_m : world.frames[l].points_m) {
        frame.points_m.push_back(turned.inverse() * point_m);
      }
      drives[1].frames.push_back(frame);
      truth.push_back(world.T_first_frame[l] * turned);
    }
  }
};

SlamSettings fleet_slam(const std::string& method) {
  SlamSettings settings;
  settings.method = method;
  settings.pairs.gaps = {16};
  settings.view = {25.0, 360.0};
  return settings;
}

}  // namespace

TEST_CASE("slam fleet: two drives that meet become one map, whatever way they went") {
  const TwoDrives two;
  for (const char* method : {"pose_graph", "landmark_ba"}) {
    INFO(method);
    FleetSettings fleet;
    fleet.lookout_step = 16;
    const FleetResult result = run_fleet(two.drives, fleet_slam(method), fleet);
    REQUIRE(result.vehicles.size() == 2);
    CHECK(result.vehicles[0].joined);
    REQUIRE(result.vehicles[1].joined);
    CHECK(result.vehicles[1].joins >= 2);
    FramePoses all = result.vehicles[0].T_map_frame;
    all.insert(all.end(), result.vehicles[1].T_map_frame.begin(),
               result.vehicles[1].T_map_frame.end());
    CHECK(aligned_error_m(all, two.truth) < 0.1);
    for (std::size_t l = 0; l < all.size(); l += 10) {
      CHECK((all[l].linear() - two.truth[l].linear()).norm() < 0.03);
    }
    // One map: the stems that both drives saw are there once.
    CHECK(result.stems.size() < two.world.stems_in_first_m.size() + 5);
  }
}

TEST_CASE("slam fleet: a drive elsewhere, one without frames and one of empty frames stay apart") {
  TwoDrives two;
  const MethodsWorld elsewhere = methods_world(400);
  two.drives.resize(1);
  VehicleDrive far;
  for (std::size_t l = 330; l < 400; l += 2) far.frames.push_back(elsewhere.frames[l]);
  two.drives.push_back(far);
  two.drives.push_back({});
  two.drives.push_back({{{0, {}}, {1, {}}}, std::nullopt});
  const FleetResult result = run_fleet(two.drives, fleet_slam("landmark_ba"), {});
  REQUIRE(result.vehicles.size() == 4);
  CHECK(result.vehicles[0].joined);
  for (const std::size_t k : {1, 2, 3}) CHECK_FALSE(result.vehicles[k].joined);
  CHECK(result.vehicles[1].T_map_frame.size() == far.frames.size());
  CHECK(result.vehicles[2].T_map_frame.empty());
  for (const VehicleMap& vehicle : result.vehicles) CHECK(all_poses_finite(vehicle.T_map_frame));
  CHECK(run_fleet({}, fleet_slam("pose_graph"), {}).vehicles.empty());
}

TEST_CASE("slam fleet: pairs are proposed by landmarks where the chain shows none") {
  const TwoDrives two;
  // One drive there and back as a single list, with a chain that is broken at the turn.
  std::vector<SparseFrame> frames = two.drives[0].frames;
  for (SparseFrame frame : two.drives[1].frames) {
    frame.number += 1000;
    frames.push_back(frame);
  }
  FramePoses chain = two.truth;
  const Pose3 lost = pose_from_rpy({60.0, 25.0, 0.0}, 0.0, 0.0, 1.0);
  for (std::size_t l = 70; l < chain.size(); ++l) chain[l] = lost * chain[l];
  SlamSettings settings = fleet_slam("pose_graph");
  settings.pairs.global = "none";
  const double without_m =
      aligned_error_m(run_slam(frames, chain, settings).T_first_frame, two.truth);
  settings.pairs.propose = true;
  settings.pairs.proposal_step = 8;
  const SlamResult with = run_slam(frames, chain, settings);
  CHECK(without_m > 2.0);
  CHECK(aligned_error_m(with.T_first_frame, two.truth) < 0.2);
}
