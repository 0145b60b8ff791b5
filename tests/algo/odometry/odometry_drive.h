#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "algo/odometry/odometry.h"
#include "tests/algo/odometry/stem_world.h"

namespace honka::stem_world {

/// A drive of 1 m/s in a bend that hands an odometry its sweeps one by one.
struct OdometryUnderTest {
  LidarModel model = vlp16();
  World world = stand(6);
  Way way = steady(pose_from_rpy({-8.0, 0.0, 1.5}, 0.02, -0.03, 0.0),
                   (Twist() << 1.0, 0, 0, 0, 0, 0.1).finished());
  std::unique_ptr<Odometry> odometry;
  std::int64_t index = 0;

  explicit OdometryUnderTest(const std::string& name)
      : odometry(create_odometry(name, model, {})) {}

  Sweep sweep_at(double start_s) { return scan(world, model, way, index++, start_s, 0.01); }
  OdometryEstimate process(const Sweep& sweep) {
    OdometryEstimate e = odometry->process(sweep);
    CHECK(e.T_odom_start.matrix().allFinite());
    CHECK(e.T_odom_end.matrix().allFinite());
    CHECK(e.covariance.allFinite());
    CHECK(std::isfinite(e.start_time_s));
    CHECK(e.sweep == sweep.index);
    return e;
  }
  OdometryEstimate at(double start_s) { return process(sweep_at(start_s)); }
  void drive(int from, int to) {
    for (int i = from; i < to; ++i) CHECK(at(0.1 * i).status == OdometryStatus::kRegistered);
  }
};

inline double distance_m(const OdometryEstimate& a, const OdometryEstimate& b) {
  return (b.T_odom_end.translation() - a.T_odom_end.translation()).norm();
}

}  // namespace honka::stem_world
