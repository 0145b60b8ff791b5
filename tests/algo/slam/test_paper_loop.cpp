#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "algo/slam/chain.h"
#include "algo/slam/correction/order.h"
#include "algo/slam/correction/update.h"
#include "algo/slam/paper_loop.h"
#include "algo/types/random.h"
#include "tests/support/slam_case.h"

namespace honka {
namespace {

/// A drive to and fro through a stand, its noisy frames, and a chain that drifts.
struct LoopWorld {
  std::vector<SparseFrame> frames;
  FramePoses truth, chain;
};

Pose3 loop_world_pose(std::size_t l, std::size_t count) {
  const double s = 2.0 * M_PI * static_cast<double>(l) / static_cast<double>(count);
  return pose_from_rpy({6.0 * std::sin(s), 3.0 * std::sin(2.0 * s), 0.0}, 0.0, 0.0,
                       0.4 * std::sin(s));
}

LoopWorld make_loop_world(std::size_t count, double noise_m, double drift_deg) {
  LoopWorld world;
  RandomStream stand(1, "loop_world_stand");
  std::vector<Eigen::Vector3d> stems;
  for (int k = 0; k < 500; ++k) {
    stems.emplace_back(stand.uniform(-36.0, 36.0), stand.uniform(-36.0, 36.0),
                       stand.uniform(-0.5, 0.5));
  }
  const Pose3 T_first_world = loop_world_pose(0, count).inverse();
  for (std::size_t l = 0; l < count; ++l) {
    RandomStream random(1, "loop_world_frame", {l});
    const Pose3 T_world_frame = loop_world_pose(l, count);
    SparseFrame frame;
    frame.number = static_cast<std::int64_t>(3 * l);  // with gaps
    for (const Eigen::Vector3d& stem : stems) {
      const Eigen::Vector3d p = T_world_frame.inverse() * stem;
      if (!ViewCone{25.0, 210.0}.holds(p.head<2>()) || random.uniform() < 0.15) continue;
      frame.points_m.emplace_back(
          p + noise_m * Eigen::Vector3d(random.normal(), random.normal(), random.normal()));
    }
    world.frames.push_back(std::move(frame));
    world.truth.push_back(T_first_world * T_world_frame);
    const Pose3 drift = pose_from_rpy({0.01 * random.normal(), 0.01 * random.normal(), 0.0}, 0.0,
                                      0.0, drift_deg * M_PI / 180.0);
    world.chain.push_back(l == 0
                              ? Pose3::Identity()
                              : Pose3(world.chain[l - 1] * between(world.truth, l - 1, l) * drift));
  }
  return world;
}

PaperLoopSettings loop_world_settings() {
  PaperLoopSettings settings;
  settings.corrections = 12;
  settings.pairs.wanted = 150;
  settings.pairs.tries = 3000;
  return settings;
}

double position_rmse_m(const FramePoses& poses, const FramePoses& truth) {
  double squares = 0.0;
  for (std::size_t l = 0; l < poses.size(); ++l) {
    squares += (poses[l].translation() - truth[l].translation()).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(poses.size()));
}

bool all_finite(const FramePoses& poses) {
  for (const Pose3& pose : poses) {
    if (!pose.matrix().allFinite()) return false;
  }
  return true;
}

constexpr ViewCone kLoopCone{25.0, 210.0};

}  // namespace

TEST_CASE("paper loop: every order, coefficient, side and acceptance keeps its promises") {
  const LoopWorld world = make_loop_world(90, 0.05, 0.25);
  for (const std::string& order : correction_order_names()) {
    for (const std::string& coefficient : power_coefficient_names()) {
      for (const std::string& side : update_side_names()) {
        PaperLoopSettings settings = loop_world_settings();
        settings.order = order;
        settings.coefficient = coefficient;
        settings.side = side;
        settings.corrections = 6;
        CAPTURE(order, coefficient, side);
        const auto result = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5);
        CHECK(all_finite(result.T_first_frame));
        CHECK(result.T_first_frame.front().matrix() == world.chain.front().matrix());
        CHECK(result.applied > 0);
        CHECK(result.applied <= result.chosen);
        CHECK(result.icp_calls == result.chosen);
        CHECK(result.blur < result.blur_before);
        CHECK(position_rmse_m(result.T_first_frame, world.truth) <
              position_rmse_m(world.chain, world.truth));
      }
    }
  }
}

TEST_CASE("paper loop: reports tell of each pair, and β falls where that is asked") {
  const LoopWorld world = make_loop_world(90, 0.05, 0.25);
  for (const std::string acceptance : {"always", "error_falls", "blur_falls"}) {
    PaperLoopSettings settings = loop_world_settings();
    settings.acceptance = acceptance;
    settings.rounds = 2;
    CAPTURE(acceptance);
    std::int64_t told = 0, applied = 0;
    double blur_before = std::numeric_limits<double>::infinity();
    FramePoses last = world.chain;
    const auto observer = [&](const CorrectionReport& report, const FramePoses& poses) {
      CHECK(report.number == told++);
      CHECK(report.round < 2);
      const bool moved = report.outcome == CorrectionOutcome::kApplied;
      applied += moved ? 1 : 0;
      if (moved) CHECK(report.overlap >= settings.match_overlap_limit);
      if (acceptance == "error_falls" && moved) CHECK(report.error_m < report.error_before_m);
      if (acceptance == "blur_falls") CHECK(report.blur <= blur_before);
      CHECK(report.blur == blur(map_points(world.frames, poses), {}));
      if (!moved) CHECK(poses.back().matrix() == last.back().matrix());
      blur_before = report.blur;
      last = poses;
    };
    const auto result = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5, observer);
    CHECK(result.chosen == told);
    CHECK(result.applied == applied);
    CHECK(result.blur == blur_before);
    CHECK(result.T_first_frame.back().matrix() == last.back().matrix());
  }
}

TEST_CASE("paper loop: the blur guard and the end condition") {
  const LoopWorld world = make_loop_world(90, 0.05, 0.25);
  PaperLoopSettings settings = loop_world_settings();
  settings.max_blur_rise = 0.02;
  double before = blur(map_points(world.frames, world.chain), {});
  const auto guard = [&](const CorrectionReport& report, const FramePoses&) {
    CHECK(report.blur <= 1.02 * before);
    before = report.blur;
  };
  (void)run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5, guard);

  settings.max_blur_rise = 0.0;
  settings.rounds = 50;
  settings.patience = 5;
  double least = std::numeric_limits<double>::infinity();
  const auto watch = [&](const CorrectionReport& report, const FramePoses&) {
    least = std::min(least, report.blur);
  };
  const auto result = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5, watch);
  CHECK(result.ended_early);
  CHECK(result.blur == std::min(least, result.blur_before));
  CHECK(result.blur == blur(map_points(world.frames, result.T_first_frame), {}));
}

TEST_CASE("paper loop: the digits depend on the seed and on nothing else") {
  const LoopWorld world = make_loop_world(60, 0.05, 0.3);
  PaperLoopSettings settings = loop_world_settings();
  settings.order = "random";
  const auto a = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5);
  const auto b = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5);
  const auto c = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 6);
  CHECK(a.blur == b.blur);
  bool other = false;
  for (std::size_t l = 0; l < a.T_first_frame.size(); ++l) {
    CHECK(a.T_first_frame[l].matrix() == b.T_first_frame[l].matrix());
    other = other || a.T_first_frame[l].matrix() != c.T_first_frame[l].matrix();
  }
  CHECK(other);
}

TEST_CASE("paper loop: frames of no use take part in no correction and break nothing") {
  LoopWorld world = make_loop_world(60, 0.05, 0.3);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  world.frames[10].points_m.clear();
  world.frames[11].points_m.resize(1);
  world.frames[12].points_m.resize(2);
  world.frames[13].points_m.assign(20, Eigen::Vector3d(1.0, 2.0, 0.0));
  world.frames[14].points_m = {{1, 1, 0}, {2, 2, 0}, {3, 3, 0}, {4, 4, 0}, {9, 9, 0}};
  world.frames[15].points_m[3] = Eigen::Vector3d(nan, 0.0, 0.0);
  world.frames[16].points_m.assign(30, Eigen::Vector3d::Constant(nan));
  for (const std::string coefficient : {"index", "errors"}) {
    PaperLoopSettings settings = loop_world_settings();
    settings.coefficient = coefficient;
    const auto observer = [](const CorrectionReport& report, const FramePoses& poses) {
      CHECK((report.pair.j < 10 || report.pair.j > 16));
      CHECK((report.pair.i < 10 || report.pair.i > 16));
      CHECK(all_finite(poses));
      CHECK(std::isfinite(report.blur));
    };
    const auto result = run_paper_loop(world.frames, world.chain, kLoopCone, settings, 5, observer);
    CHECK(result.applied > 0);
    CHECK(all_finite(result.T_first_frame));
    CHECK(result.blur < result.blur_before);
  }
}

TEST_CASE("paper loop: nothing to do is done") {
  for (const std::size_t count : {0U, 1U, 2U, 3U}) {
    const PaperLoopSettings defaults;
    const std::vector<SparseFrame> frames(count);
    const auto result =
        run_paper_loop(frames, FramePoses(count, Pose3::Identity()), {}, defaults, 1);
    CHECK(result.T_first_frame.size() == count);
    CHECK(result.chosen == 0);
    CHECK(result.applied == 0);
  }
}

}  // namespace honka
