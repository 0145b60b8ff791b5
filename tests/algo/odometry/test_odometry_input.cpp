#include <catch2/catch.hpp>
#include <limits>
#include <memory>

#include "tests/algo/odometry/odometry_drive.h"

using namespace honka;
using namespace honka::stem_world;

// What bad input gets, as one law over every odometry.

TEST_CASE("odometry input: a gap is told and bridged") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 10);
    const OdometryEstimate before = d.at(1.0);
    const OdometryEstimate after = d.at(2.0);
    CHECK(after.status == OdometryStatus::kRegistered);
    CHECK(after.cause == OdometryCause::kGap);
    CHECK(distance_m(before, after) == Approx(1.0).margin(0.1));
    CHECK(d.at(2.1).cause == OdometryCause::kNone);
  }
}

TEST_CASE("odometry input: repeated, reversed and impossible times are refused") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 10);
    const Sweep sweep = d.sweep_at(1.0);
    const OdometryEstimate first = d.process(sweep);
    const OdometryEstimate again = d.process(sweep);
    CHECK(again.status == OdometryStatus::kRefused);
    CHECK(again.cause == OdometryCause::kRepeatedTime);
    CHECK(again.T_odom_end.matrix() == first.T_odom_end.matrix());
    CHECK(d.at(0.5).cause == OdometryCause::kReversedTime);
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      Sweep broken = sweep;
      broken.start_time_s = bad;
      CHECK(d.process(broken).cause == OdometryCause::kNotFinite);
      broken = sweep;
      broken.start_azimuth_rad = bad;
      const OdometryEstimate e = d.process(broken);
      CHECK(e.status == OdometryStatus::kRefused);
      CHECK(e.cause == OdometryCause::kNotFinite);
    }
    d.drive(11, 15);
  }
}

TEST_CASE("odometry input: empty scans are predicted, and the drive goes on") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 10);
    const OdometryEstimate before = d.at(1.0);
    for (int i = 11; i < 14; ++i) {
      Sweep sweep = d.sweep_at(0.1 * i);
      if (i == 12) sweep.returns.clear();
      for (Return& r : sweep.returns) r.range_ticks = 0;
      const OdometryEstimate e = d.process(sweep);
      CHECK(e.status == OdometryStatus::kPredicted);
      CHECK(e.cause == OdometryCause::kEmptyScan);
      CHECK(e.covariance(0, 0) >= kUnobservedVariance);
      CHECK(distance_m(before, e) == Approx(0.1 * (i - 10)).margin(0.05));
    }
    d.drive(14, 20);
  }
}

TEST_CASE("odometry input: a run that begins with empty scans starts with the first that sees") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    for (int i = 0; i < 3; ++i) {
      Sweep sweep = d.sweep_at(0.1 * i);
      sweep.returns.clear();
      CHECK(d.process(sweep).status == OdometryStatus::kPredicted);
    }
    d.drive(3, 10);
  }
}

TEST_CASE("odometry input: blind for an hour, it coasts for a moment and then stands") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 5);
    OdometryEstimate e;
    for (int i = 0; i < 60; ++i) {
      Sweep none;
      none.index = i;
      none.start_time_s = 1.0 + 60.0 * i;
      e = d.process(none);
    }
    CHECK(e.T_odom_end.translation().norm() < 5.0);
  }
}

TEST_CASE("odometry input: returns that make no sense do no harm") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 5);
    RandomStream random(3, "odometry_input_noise");
    for (int i = 5; i < 15; ++i) {
      Sweep sweep = d.sweep_at(0.1 * i);
      for (Return& r : sweep.returns) {
        r.range_ticks = static_cast<std::uint16_t>(random.uniform(0.0, 65535.0));
        if (i % 3 == 0) r.time_offset_ns = static_cast<std::uint32_t>(random.uniform(0.0, 4e9));
        if (i % 3 == 1) r.laser = static_cast<std::uint8_t>(random.uniform(0.0, 255.0));
      }
      (void)d.process(sweep);
    }
    for (int i = 15; i < 20; ++i) (void)d.at(0.1 * i);
    d.drive(20, 25);
  }
}

TEST_CASE("odometry input: a start without motion stays where it is") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.way = steady(pose_from_rpy({0.0, 0.0, 1.5}, 0.02, -0.03, 0.0), Twist::Zero());
    const OdometryEstimate first = d.at(0.0);
    OdometryEstimate last;
    for (int i = 1; i < 20; ++i) last = d.at(0.1 * i);
    CHECK(last.status == OdometryStatus::kRegistered);
    CHECK(distance_m(first, last) < 0.01);
  }
}

TEST_CASE("odometry input: a jump of 5 m is told, and the map found again") {
  for (const std::string& name : odometry_names()) {
    INFO(name);
    OdometryUnderTest d(name);
    d.drive(0, 20);
    const OdometryEstimate before = d.at(2.0);
    const Way way = d.way;
    d.way = [&](double t) { return Pose3(Eigen::Translation3d(4.0, 3.0, 0.0) * way(t)); };
    const OdometryEstimate after = d.at(2.1);
    CHECK(after.cause == OdometryCause::kJump);
    CHECK(after.status == OdometryStatus::kRegistered);
    CHECK(distance_m(before, after) == Approx(5.0).margin(0.2));
    d.drive(22, 30);
  }
}
