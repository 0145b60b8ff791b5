#include "eval/run/windows.h"

#include <catch2/catch.hpp>
#include <set>

using namespace honka;
using namespace honka::eval;

namespace {

ProtocolSettings protocol(std::vector<std::int64_t> frames, std::int64_t windows) {
  ProtocolSettings settings;
  settings.frames = std::move(frames);
  settings.windows = windows;
  return settings;
}

std::vector<std::size_t> last_frames(std::size_t key_frames, const ProtocolSettings& settings) {
  std::vector<std::size_t> last;
  for (const Window& window : disjoint_windows(key_frames, settings)) {
    CHECK(window.number == static_cast<std::int64_t>(last.size()));
    last.push_back(window.last_key_frame);
  }
  return last;
}

/// A run of key frames a metre apart along x, each with one return 5 m straight ahead.
struct StraightRun {
  Drive drive;
  LidarModel model = vlp16();
  ScannedRun scanned;

  explicit StraightRun(int key_frames) {
    for (int k = 0; k < key_frames; ++k) {
      KeyFrame key_frame;
      key_frame.T_odom_lidar = pose_from_rpy({double(k), 0.0, 1.5}, 0.0, 0.1, 0.0);
      key_frame.sweeps.push_back({k, key_frame.T_odom_lidar, key_frame.T_odom_lidar});
      drive.key_frames.push_back(key_frame);
      Sweep sweep;
      sweep.index = k;
      Return ahead;
      ahead.range_ticks = 2500;
      ahead.laser = 1;
      sweep.returns.push_back(ahead);
      scanned.scans.push_back({sweep});
    }
    scanned.drive = &drive;
    scanned.model = &model;
  }
};

}  // namespace

TEST_CASE("windows as counted by hand") {
  using Frames = std::vector<std::size_t>;
  CHECK(last_frames(37, protocol({1, 3, 10}, 0)) == Frames{9, 19, 29});
  CHECK(last_frames(30, protocol({1, 3, 10}, 0)) == Frames{9, 19, 29});
  CHECK(last_frames(100, protocol({10}, 4)) == Frames{9, 29, 59, 79});
  CHECK(last_frames(100, protocol({10}, 40)).size() == 10);
  CHECK(last_frames(9, protocol({1, 3, 10}, 0)).empty());
  CHECK(last_frames(0, protocol({1}, 5)).empty());
  CHECK(last_frames(4, protocol({1}, 0)) == Frames{0, 1, 2, 3});
}

TEST_CASE("with windows of each, every number of frames has disjoint windows of its own") {
  ProtocolSettings settings = protocol({1, 3}, 4);
  settings.windows_of = "each";
  const auto windows = disjoint_windows(10, settings);
  REQUIRE(windows.size() == 7);
  const std::vector<std::size_t> last = {0, 2, 5, 7, 2, 5, 8};
  for (std::size_t i = 0; i < windows.size(); ++i) {
    CHECK(windows[i].number == static_cast<std::int64_t>(i));
    CHECK(windows[i].last_key_frame == last[i]);
    CHECK(windows[i].frames == std::vector<std::int64_t>{i < 4 ? 1 : 3});
  }
  settings.windows_of = "longest";
  for (const Window& window : disjoint_windows(10, settings)) {
    CHECK(window.frames == std::vector<std::int64_t>{1, 3});
  }
}

TEST_CASE("windows share no key frame, lie inside the drive and are as many as asked") {
  for (std::size_t key_frames = 0; key_frames < 60; ++key_frames) {
    for (const std::int64_t width : {1, 3, 7}) {
      for (const std::int64_t limit : {0, 1, 4, 1000}) {
        const auto last = last_frames(key_frames, protocol({1, width}, limit));
        const std::size_t available = key_frames / static_cast<std::size_t>(width);
        CHECK(last.size() == (limit == 0 ? available : std::min<std::size_t>(available, limit)));
        std::set<std::size_t> used;
        for (const std::size_t end : last) {
          REQUIRE(end < key_frames);
          for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k) used.insert(end - k);
        }
        CHECK(used.size() == last.size() * static_cast<std::size_t>(width));
      }
    }
  }
}

TEST_CASE("clouds of all numbers of frames stand in the levelled frame of the last key frame") {
  const StraightRun run(8);
  KeyFrameSettings settings;
  settings.min_range_m = 1.0;
  const Window window{0, 6, {1, 3, 5}};
  for (const std::int64_t frames : {1, 3, 5}) {
    const LocalCloud cloud = window_cloud(run.scanned, window, frames, settings);
    REQUIRE(cloud.points_m.size() == static_cast<std::size_t>(frames));
    // Frame by frame, the last at the end: each a metre farther back than the next.
    for (std::size_t k = 0; k < cloud.points_m.size(); ++k) {
      const double back_m = static_cast<double>(frames) - 1.0 - static_cast<double>(k);
      const Eigen::Vector3d step_m =
          Eigen::Vector3d(cloud.points_m[k]) - Eigen::Vector3d(cloud.points_m.back());
      CHECK(step_m.x() == Approx(-back_m).margin(1e-5));
      CHECK(step_m.tail<2>().norm() == Approx(0.0).margin(1e-5));
    }
    CHECK(Eigen::Vector3d(cloud.points_m.back()).norm() == Approx(5.0).margin(0.02));
  }
}
