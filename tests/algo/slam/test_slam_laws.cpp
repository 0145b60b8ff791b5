// What every method of SLAM keeps, whatever its name; and what bad input gets.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "algo/slam/slam.h"
#include "algo/types/user_error.h"
#include "tests/algo/slam/methods_world.h"

namespace {

using namespace honka;
using namespace honka::test;

SlamSettings slam_settings(const std::string& method) {
  SlamSettings settings;
  settings.method = method;
  settings.pairs.gaps = {10, 40};
  settings.loop.corrections = 10;
  return settings;
}

bool counts_every_frame(const SlamResult& result, std::size_t frames) {
  return result.T_first_frame.size() == frames && result.frames.size() == frames;
}

std::size_t count_of(const SlamResult& result, FrameStatus status) {
  return static_cast<std::size_t>(std::count(result.frames.begin(), result.frames.end(), status));
}

/// Notes the stages it is told of.
struct StageNotes : SlamObserver {
  void after_stage(std::string_view stage, const FramePoses& T_first_frame) override {
    stages.emplace_back(stage);
    finite = finite && all_poses_finite(T_first_frame);
  }
  std::vector<std::string> stages;
  bool finite = true;
};

}  // namespace

TEST_CASE("slam methods: a perfect chain through a world without noise stays") {
  const MethodsWorld world = methods_world(60);
  for (const std::string& method : slam_method_names()) {
    INFO(method);
    const auto result = run_slam(world.frames, world.T_first_frame, slam_settings(method));
    CHECK(counts_every_frame(result, 60));
    CHECK(largest_difference(result.T_first_frame, world.T_first_frame) < 1e-6);
    CHECK(count_of(result, FrameStatus::kPlaced) == 60);
    CHECK(result.T_first_frame.front().matrix() == Pose3::Identity().matrix());
    REQUIRE(result.stems.size() > 100);
    for (const MapStem& stem : result.stems) CHECK(stem.rmse_m < 1e-6);
  }
}

TEST_CASE("slam methods: the same call gives the same digits, stages come in order, all finite") {
  const MethodsWorld world = methods_world(50, 0.05);
  const FramePoses bent = bent_chain(world.T_first_frame, 0.003, 0.02);
  for (const std::string& method : slam_method_names()) {
    INFO(method);
    StageNotes notes;
    const auto one = run_slam(world.frames, bent, slam_settings(method), &notes, 3);
    const auto two = run_slam(world.frames, bent, slam_settings(method), nullptr, 3);
    CHECK(largest_difference(one.T_first_frame, two.T_first_frame) == 0.0);
    CHECK(one.stems.size() == two.stems.size());
    CHECK(notes.finite);
    REQUIRE(notes.stages.size() == one.times.size());
    CHECK(notes.stages.front() == "chain");
    CHECK(notes.stages.back() == "map");
  }
}

TEST_CASE("slam methods: a bent chain is straightened by each method beyond the paper") {
  const MethodsWorld world = methods_world(100, 0.03);
  const FramePoses bent = bent_chain(world.T_first_frame, 0.004, 0.03);
  const double bent_m = aligned_error_m(bent, world.T_first_frame);
  for (const char* method : {"interpolate", "pose_graph", "landmark_ba"}) {
    INFO(method);
    const auto result = run_slam(world.frames, bent, slam_settings(method));
    CHECK(aligned_error_m(result.T_first_frame, world.T_first_frame) < 0.05 * bent_m);
    CHECK(result.matches.size() >= 4);
    CHECK(result.bad_steps == 0);
  }
}

TEST_CASE("slam methods: without a chain one is made, a chain that starts elsewhere is moved") {
  const MethodsWorld world = methods_world(40, 0.02);
  const Pose3 elsewhere = pose_from_rpy({500.0, -20.0, 3.0}, 0.1, 0.0, 2.0);
  FramePoses moved_chain;
  for (const Pose3& pose : world.T_first_frame) moved_chain.push_back(elsewhere * pose);
  for (const std::string& method : slam_method_names()) {
    INFO(method);
    const auto own = run_slam(world.frames, std::nullopt, slam_settings(method));
    CHECK(aligned_error_m(own.T_first_frame, world.T_first_frame) < 0.5);
    const auto given = run_slam(world.frames, moved_chain, slam_settings(method));
    CHECK(given.T_first_frame.front().matrix() == Pose3::Identity().matrix());
    CHECK(aligned_error_m(given.T_first_frame, world.T_first_frame) < 0.05);
  }
}

TEST_CASE("slam methods: frames of 0, 1, 2, collinear, equal, NaN and far stems get a status") {
  MethodsWorld world = methods_world(40, 0.02);
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  auto& frames = world.frames;
  frames[5].points_m.clear();
  frames[8].points_m.resize(1);
  frames[11].points_m.resize(2);
  frames[14].points_m = {{1.0, 1.0, 0.0}, {2.0, 2.0, 0.0}, {3.0, 3.0, 0.0}, {9.0, 9.0, 0.0}};
  frames[17].points_m.assign(6, {4.0, 2.0, 0.0});
  frames[20].points_m[3].y() = kNaN;
  frames[23].points_m[0].x() = std::numeric_limits<double>::infinity();
  frames[26].points_m.emplace_back(1e300, 0.0, 0.0);
  const auto once = frames[29].points_m;
  frames[29].points_m.insert(frames[29].points_m.end(), once.begin(), once.end());
  for (std::size_t l = 30; l < frames.size(); ++l) frames[l].number += 1000;
  for (const std::string& method : slam_method_names()) {
    for (const bool given : {true, false}) {
      INFO(method << (given ? " with" : " without") << " a chain");
      const auto chain = given ? std::optional(world.T_first_frame) : std::nullopt;
      const auto result = run_slam(frames, chain, slam_settings(method));
      CHECK(counts_every_frame(result, 40));
      CHECK(all_poses_finite(result.T_first_frame));
      for (const std::size_t l : {5, 8, 11, 14, 17}) {
        CHECK(result.frames[l] == FrameStatus::kTooFewPoints);
      }
      for (const std::size_t l : {20, 23, 26}) CHECK(result.frames[l] == FrameStatus::kNotFinite);
      CHECK(result.frames[29] == FrameStatus::kPlaced);
      if (given) CHECK(aligned_error_m(result.T_first_frame, world.T_first_frame) < 0.3);
    }
  }
}

TEST_CASE("slam methods: nothing in common, nothing at all, one frame, two frames") {
  std::vector<SparseFrame> disjoint;
  for (std::int64_t l = 0; l < 6; ++l) {
    const double at = 7.0 * static_cast<double>(l);
    disjoint.push_back({l, {{5.0 + at, 0.3 * at, 0.0}, {-3.0, 9.0 - at, 1.0}, {at, -4.0, 0.5}}});
  }
  const std::vector<SparseFrame> empty = {{0, {}}, {4, {}}, {9, {}}};
  const MethodsWorld world = methods_world(2);
  for (const std::string& method : slam_method_names()) {
    INFO(method);
    CHECK(all_poses_finite(run_slam(disjoint, std::nullopt, slam_settings(method)).T_first_frame));
    const auto nothing = run_slam(empty, std::nullopt, slam_settings(method));
    CHECK(all_poses_finite(nothing.T_first_frame));
    CHECK(count_of(nothing, FrameStatus::kTooFewPoints) == 3);
    CHECK(nothing.stems.empty());
    const std::vector<SparseFrame> one = {world.frames[0]};
    CHECK(run_slam(one, std::nullopt, slam_settings(method)).frames[0] == FrameStatus::kPlaced);
    const auto two = run_slam(world.frames, std::nullopt, slam_settings(method));
    CHECK(largest_difference(two.T_first_frame, world.T_first_frame) < 1e-6);
  }
}

TEST_CASE("slam methods: what cannot be meant is one line of complaint") {
  const MethodsWorld world = methods_world(3);
  const auto run = [&](const SlamSettings& settings, const FramePoses& chain) {
    return run_slam(world.frames, chain, settings);
  };
  const SlamSettings defaults;
  SlamSettings wrong_start;
  wrong_start.start = "anywhere";
  CHECK_THROWS_WITH(run(slam_settings("orb"), world.T_first_frame), Catch::Contains("landmark_ba"));
  CHECK_THROWS_WITH(run(wrong_start, world.T_first_frame), Catch::Contains("rechained"));
  CHECK_THROWS_WITH(run(defaults, FramePoses(2, Pose3::Identity())), Catch::Contains("2 poses"));
  FramePoses nan = world.T_first_frame;
  nan[1].translation().y() = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(run(defaults, nan), Catch::Contains("pose 1"));
  FramePoses scaled = world.T_first_frame;
  scaled[2].linear() *= 2.0;
  CHECK_THROWS_AS(run(defaults, scaled), UserError);
  CHECK_THROWS_AS(run_slam({}, std::nullopt, defaults), UserError);
  auto falling = world.frames;
  falling[2].number = 1;
  CHECK_THROWS_WITH(run_slam(falling, std::nullopt, defaults), Catch::Contains("must rise"));
}
