#include <catch2/catch.hpp>
#include <limits>

#include "algo/odometry/stems/stem_odometry.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;
using namespace honka::stem_world;

namespace {

const LidarModel kInputModel = vlp16();

/// A drive that hands over sweeps one by one.
struct StemDrive {
  World world = stand();
  Way way = steady(pose_from_rpy({-8.0, 0.0, 1.5}, 0.02, -0.03, 0.0),
                   (Twist() << 1.0, 0, 0, 0, 0, 0.1).finished());
  StemOdometry odometry{kInputModel, {}};
  std::int64_t index = 0;

  Sweep sweep_at(double start_s) { return scan(world, kInputModel, way, index++, start_s); }
  OdometryEstimate process(const Sweep& sweep) {
    OdometryEstimate e = odometry.process(sweep);
    CHECK(e.T_odom_start.matrix().allFinite());
    CHECK(e.T_odom_end.matrix().allFinite());
    CHECK(e.covariance.allFinite());
    CHECK(e.sweep == sweep.index);
    return e;
  }
  OdometryEstimate at(double start_s) { return process(sweep_at(start_s)); }
  void drive(int from, int to) {
    for (int i = from; i < to; ++i) CHECK(at(0.1 * i).status == OdometryStatus::kRegistered);
  }
};

double way_between_m(const OdometryEstimate& a, const OdometryEstimate& b) {
  return (b.T_odom_end.translation() - a.T_odom_end.translation()).norm();
}

}  // namespace

TEST_CASE("stems input: a gap is told and bridged") {
  StemDrive d;
  d.drive(0, 10);
  const OdometryEstimate before = d.at(1.0);
  const OdometryEstimate after = d.at(2.0);
  CHECK(after.status == OdometryStatus::kRegistered);
  CHECK(after.cause == OdometryCause::kGap);
  CHECK(way_between_m(before, after) == Approx(1.0).margin(0.1));
  CHECK(d.at(2.1).cause == OdometryCause::kNone);
}

TEST_CASE("stems input: repeated, reversed and impossible times are refused") {
  StemDrive d;
  d.drive(0, 10);
  const Sweep sweep = d.sweep_at(1.0);
  const OdometryEstimate first = d.process(sweep);
  const OdometryEstimate again = d.process(sweep);
  CHECK(again.status == OdometryStatus::kRefused);
  CHECK(again.cause == OdometryCause::kRepeatedTime);
  CHECK(again.T_odom_end.isApprox(first.T_odom_end));
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

TEST_CASE("stems input: an empty scan is predicted, and the drive goes on") {
  StemDrive d;
  d.drive(0, 10);
  const OdometryEstimate before = d.at(1.0);
  for (int i = 11; i < 14; ++i) {
    Sweep sweep = d.sweep_at(0.1 * i);
    if (i == 12) sweep.returns.clear();
    for (Return& r : sweep.returns) r.range_ticks = 0;
    const OdometryEstimate e = d.process(sweep);
    CHECK(e.status == OdometryStatus::kPredicted);
    CHECK(e.cause == OdometryCause::kEmptyScan);
    CHECK(way_between_m(before, e) == Approx(0.1 * (i - 10)).margin(0.05));
  }
  d.drive(14, 20);
}

TEST_CASE("stems input: a run that begins with empty scans starts with the first that sees") {
  StemDrive d;
  for (int i = 0; i < 3; ++i) {
    Sweep sweep = d.sweep_at(0.1 * i);
    sweep.returns.clear();
    CHECK(d.process(sweep).status == OdometryStatus::kPredicted);
  }
  d.drive(3, 10);
}

TEST_CASE("stems input: nothing but empty scans stays finite for an hour") {
  StemDrive d;
  d.drive(0, 5);
  OdometryEstimate e;
  for (int i = 0; i < 60; ++i) {
    Sweep sweep;
    sweep.index = i;
    sweep.start_time_s = 1.0 + 60.0 * i;
    e = d.process(sweep);
  }
  CHECK(e.T_odom_end.translation().norm() < 5.0);  // it coasts for a second, then stands
}

TEST_CASE("stems input: returns that make no sense do no harm") {
  StemDrive d;
  d.drive(0, 5);
  RandomStream random(3, "stem_input_noise");
  for (int i = 5; i < 15; ++i) {
    Sweep sweep = d.sweep_at(0.1 * i);
    for (Return& r : sweep.returns) {
      r.range_ticks = static_cast<std::uint16_t>(random.uniform(0.0, 65535.0));
      if (i % 3 == 0) r.time_offset_ns = static_cast<std::uint32_t>(random.uniform(0.0, 4e9));
      if (i % 3 == 1) r.laser = static_cast<std::uint8_t>(random.uniform(0.0, 255.0));
    }
    (void)d.process(sweep);
  }
  d.drive(15, 20);
}

TEST_CASE("stems input: too few stems are told, and the ground alone is not enough") {
  StemDrive d;
  d.drive(0, 5);
  const World stems = d.world;
  d.world.trunks.clear();
  for (int i = 5; i < 8; ++i) {
    const OdometryEstimate e = d.at(0.1 * i);
    CHECK(e.status == OdometryStatus::kPredicted);
    CHECK(e.cause == OdometryCause::kFewFeatures);
  }
  d.world = stems;
  d.drive(8, 12);
}

TEST_CASE("stems input: without ground the height is not observed") {
  StemDrive d;
  d.world.ground = false;
  (void)d.at(0.0);
  const OdometryEstimate e = d.at(0.1);
  CHECK(e.status == OdometryStatus::kDegenerate);
  CHECK(e.cause == OdometryCause::kUnobserved);
  CHECK(e.covariance(2, 2) > 10.0);
}

TEST_CASE("stems input: a start without motion") {
  StemDrive d;
  d.way = steady(pose_from_rpy({0.0, 0.0, 1.5}, 0.02, -0.03, 0.0), Twist::Zero());
  const OdometryEstimate first = d.at(0.0);
  OdometryEstimate last;
  for (int i = 1; i < 20; ++i) last = d.at(0.1 * i);
  CHECK(last.status == OdometryStatus::kRegistered);
  CHECK(way_between_m(first, last) < 0.01);
}

TEST_CASE("stems input: a jump of 5 m is found and told") {
  StemDrive d;
  d.drive(0, 20);
  const OdometryEstimate before = d.at(2.0);
  const Way way = d.way;
  d.way = [&](double t) -> Pose3 {
    Pose3 pose = way(t);
    pose.translation().x() += 4.0;
    pose.translation().y() += 3.0;
    return pose;
  };
  const OdometryEstimate after = d.at(2.1);
  CHECK(after.cause == OdometryCause::kJump);
  CHECK(after.status == OdometryStatus::kRegistered);
  CHECK(way_between_m(before, after) == Approx(5.0).margin(0.2));
  d.drive(22, 30);
}

TEST_CASE("stems input: a jump to a place never seen begins a new map there") {
  StemDrive d;
  d.drive(0, 10);
  const Way way = d.way;
  d.world = stand(5, 0.0, 77);
  int lost = 0;
  OdometryEstimate e;
  for (int i = 10; i < 20; ++i) {
    e = d.at(0.1 * i);
    lost += e.status == OdometryStatus::kPredicted ? 1 : 0;
  }
  CHECK(lost >= 1);
  CHECK(lost <= 4);
  CHECK(e.status == OdometryStatus::kRegistered);
}
