#include <catch2/catch.hpp>

#include "algo/odometry/key_frames.h"

using namespace honka;

namespace {

Pose3 at(double x_m, double yaw_rad = 0.0) {
  return pose_from_rpy({x_m, 0.0, 0.0}, 0.0, 0.0, yaw_rad);
}

}  // namespace

TEST_CASE("a key frame every 0.3 m of a straight drive") {
  KeyFrameSelector selector{KeyFrameSettings{}};
  int frames = 0;
  for (int step = 0; step <= 100; ++step) frames += selector.is_key_frame(at(0.1 * step)) ? 1 : 0;
  CHECK(frames == 34);  // 0, 0.3, …, 9.9 m
}

TEST_CASE("a key frame every 30° of a turn on the spot, about any axis") {
  KeyFrameSelector yaw{KeyFrameSettings{}}, roll{KeyFrameSettings{}};
  int yaw_frames = 0, roll_frames = 0;
  for (int deg = 0; deg <= 360; deg += 10) {
    yaw_frames += yaw.is_key_frame(at(0.0, deg_to_rad(deg))) ? 1 : 0;
    const Pose3 rolled = pose_from_rpy({0, 0, 0}, deg_to_rad(deg), 0.0, 0.0);
    roll_frames += roll.is_key_frame(rolled) ? 1 : 0;
  }
  CHECK(yaw_frames == 13);
  CHECK(roll_frames == 13);
}

TEST_CASE("the way counts in three dimensions and from the last key frame") {
  KeyFrameSelector selector{KeyFrameSettings{}};
  CHECK(selector.is_key_frame(at(0.0)));
  CHECK_FALSE(selector.is_key_frame(at(0.29)));
  CHECK_FALSE(selector.is_key_frame(at(-0.29)));
  CHECK_FALSE(selector.is_key_frame(at(0.2, deg_to_rad(29.0))));
  CHECK(selector.is_key_frame(pose_from_rpy({0.2, 0.2, 0.2}, 0.0, 0.0, 0.0)));
}
