#include <catch2/catch.hpp>

#include "tests/algo/odometry/odometry_drive.h"

using namespace honka;
using namespace honka::stem_world;

// What bad input gets beyond the law of test_odometry_input.cpp.

TEST_CASE("loam input: after a gap longer than velocity is trusted for, it looks around") {
  OdometryUnderTest d("loam");
  d.way = steady(pose_from_rpy({-8.0, 0.0, 1.5}, 0.01, -0.01, 0.0),
                 (Twist() << 1.0, 0, 0, 0, 0, 0.05).finished());
  d.drive(0, 20);
  const OdometryEstimate before = d.at(2.0);
  const OdometryEstimate far = d.at(6.0);
  CHECK(far.status == OdometryStatus::kRegistered);
  CHECK(far.cause == OdometryCause::kGap);
  CHECK(distance_m(before, far) == Approx(4.0).margin(0.15));
  d.drive(61, 65);
}

TEST_CASE("loam input: few returns are few features") {
  OdometryUnderTest d("loam");
  d.drive(0, 5);
  Sweep sweep = d.sweep_at(0.5);
  sweep.returns.resize(40);
  for (Return& r : sweep.returns) r.range_ticks = 4000;
  const OdometryEstimate e = d.process(sweep);
  CHECK(e.status == OdometryStatus::kPredicted);
  CHECK(e.cause == OdometryCause::kFewFeatures);
  d.drive(6, 8);
}

TEST_CASE("loam input: a jump out of the map is told, and what is there is the new map") {
  OdometryUnderTest d("loam");
  d.drive(0, 10);
  d.world = turned(stand(6, 0.0, 9), 1.0);
  for (Trunk& trunk : d.world.trunks) trunk.foot_m.x() += 0.5;
  int predicted = 0;
  for (int i = 10; i < 20; ++i) {
    const OdometryEstimate e = d.at(0.1 * i);
    if (e.status == OdometryStatus::kPredicted) ++predicted;
  }
  CHECK(predicted >= 1);
  d.drive(20, 25);
}
