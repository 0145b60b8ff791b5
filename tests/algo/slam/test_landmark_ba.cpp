// Poses and stems together: exact worlds, the gradient, bushes, frames that see nothing.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/slam/chain.h"
#include "algo/slam/methods/landmark_ba.h"
#include "algo/slam/methods/landmark_system.h"
#include "algo/types/random.h"
#include "tests/algo/slam/methods_world.h"

namespace {

using namespace honka;
using namespace honka::test;

/// Each pose but the first moved by up to `size` metres and a hundredth of it in radians.
FramePoses shaken(const FramePoses& poses, double size) {
  FramePoses result = poses;
  for (std::size_t l = 1; l < poses.size(); ++l) {
    RandomStream random(7, "shaken", {l});
    Twist step;
    for (Eigen::Index k = 0; k < 6; ++k) {
      step[k] = random.uniform(-1.0, 1.0) * (k < 3 ? size : 0.01 * size);
    }
    result[l] = stepped(poses[l], step);
  }
  return result;
}

/// Ties so weak that exact observations decide alone.
LandmarkBaSettings untied() {
  LandmarkBaSettings settings;
  settings.chain_m = 1e4;
  settings.chain_deg = 180.0;
  settings.rounds = 3;
  settings.iterations = 10;
  return settings;
}

}  // namespace

TEST_CASE("landmark ba: exact observations recover poses and stems from a shaken start") {
  const MethodsWorld world = methods_world(60);
  const auto result =
      adjust_landmarks(world.frames, shaken(world.T_first_frame, 0.1), {}, untied());
  CHECK(largest_difference(result.T_first_frame, world.T_first_frame) < 1e-6);
  CHECK(result.final_cost < 1e-4);  // of the ties, which were measured on the shaken start
  CHECK(result.free_frames == 0);
  for (const MapStem& stem : result.map.stems) {
    double nearest_m = 1e9;
    for (const auto& true_m : world.stems_in_first_m) {
      nearest_m = std::min(nearest_m, (true_m - stem.position_in_first_m).norm());
    }
    CHECK(nearest_m < 1e-6);
    CHECK(stem.rmse_m < 1e-6);
  }
}

TEST_CASE("landmark ba: the gradient is that of the cost") {
  const MethodsWorld world = methods_world(12, 0.1);
  const FramePoses at = shaken(world.T_first_frame, 0.15);
  const StemMap3 map = build_stem_map(world.frames, world.T_first_frame, {});
  std::vector<Eigen::Vector3d> stems_m;
  for (const MapStem& stem : map.stems) stems_m.push_back(stem.position_in_first_m);
  std::vector<ChainTie> ties;
  for (std::size_t l = 0; l + 1 < at.size(); ++l) {
    ties.push_back({l, between(world.T_first_frame, l, l + 1)});
  }
  LandmarkSystem system(world.frames, map, ties, {10.0, 8.0, 2.0, 20.0, 60.0});
  system.linearize(at, stems_m);
  constexpr double kDelta = 1e-5;
  for (const std::size_t l : {std::size_t{0}, std::size_t{5}, at.size() - 1}) {
    for (Eigen::Index k = 0; k < 6; ++k) {
      FramePoses ahead = at, behind = at;
      ahead[l] = stepped(at[l], kDelta * Twist::Unit(k));
      behind[l] = stepped(at[l], -kDelta * Twist::Unit(k));
      const double numeric =
          (system.cost(ahead, stems_m) - system.cost(behind, stems_m)) / (2.0 * kDelta);
      CHECK(system.pose_gradient()[l][k] == Approx(numeric).epsilon(1e-5).margin(1e-3));
    }
  }
}

TEST_CASE("landmark ba: noise, bushes and false points leave poses within what noise allows") {
  MethodsWorld world = methods_world(80, 0.05);
  for (std::size_t l = 0; l < world.frames.size(); ++l) {
    RandomStream random(11, "bushes", {l});
    for (int k = 0; k < 12; ++k) {  // a bush 6 m wide beside the track, and points anywhere
      const Eigen::Vector3d bush_m(20.0 + random.uniform(-3.0, 3.0),
                                   4.0 + random.uniform(-3.0, 3.0), 1.0);
      world.frames[l].points_m.push_back(world.T_first_frame[l].inverse() * bush_m);
      world.frames[l].points_m.emplace_back(random.uniform(-25.0, 25.0),
                                            random.uniform(-25.0, 25.0), 0.0);
    }
  }
  const FramePoses start = shaken(world.T_first_frame, 0.1);
  const auto result = adjust_landmarks(world.frames, start, {}, {});
  CHECK(aligned_error_m(result.T_first_frame, world.T_first_frame) < 0.02);
  CHECK(result.final_cost < result.initial_cost + 1e-9);
}

TEST_CASE("landmark ba: frames that see nothing or little hang on their neighbours, all finite") {
  MethodsWorld world = methods_world(60, 0.03);
  for (std::size_t l = 20; l < 30; ++l) world.frames[l].points_m.clear();
  world.frames[40].points_m.resize(1);
  world.frames[50].points_m.resize(2);
  const auto result = adjust_landmarks(world.frames, world.T_first_frame, {}, {});
  CHECK(all_poses_finite(result.T_first_frame));
  CHECK(result.free_frames == 10);
  CHECK(aligned_error_m(result.T_first_frame, world.T_first_frame) < 0.05);
  const auto nothing =
      adjust_landmarks(std::vector<SparseFrame>(5), FramePoses(5, Pose3::Identity()), {}, {});
  CHECK(all_poses_finite(nothing.T_first_frame));
  CHECK(nothing.map.stems.empty());
  CHECK(adjust_landmarks({}, {}, {}, {}).T_first_frame.empty());
}

TEST_CASE("landmark ba: one frame sees a stem once, the nearest of two points") {
  std::vector<SparseFrame> frames;
  for (std::int64_t l = 0; l < 6; ++l) {
    frames.push_back({l, {{5.0, 0.0, 0.0}, {5.2, 0.0, 0.0}, {0.0, 7.0, 0.0}}});
  }
  frames[3].points_m.erase(frames[3].points_m.begin());
  const StemMap3 map = build_stem_map(frames, FramePoses(6, Pose3::Identity()), {0.5, 5});
  REQUIRE(map.stems.size() == 2);
  for (const MapStem& stem : map.stems) CHECK(stem.observations == 6);
  CHECK(map.observations.size() == 12);
  CHECK(build_stem_map(frames, FramePoses(6, Pose3::Identity()), {0.5, 7}).stems.empty());
}
