#include <catch2/catch.hpp>
#include <limits>

#include "algo/odometry/loam/loam.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;
using namespace honka::stem_world;

namespace {

const LidarModel kLoamInputModel = vlp16();

/// A drive of 1 m/s in a bend that hands over its sweeps one by one; `ahead_m` moves it along x.
struct LoamDrive {
  World world = stand(6);
  Way way = steady(pose_from_rpy({-6.0, 0.0, 1.5}, 0.01, -0.01, 0.0),
                   (Twist() << 1.0, 0, 0, 0, 0, 0.05).finished());
  LoamOdometry odometry{kLoamInputModel, {}};
  std::int64_t index = 0;
  double ahead_m = 0.0;

  Sweep sweep_at(double start_s) {
    const Way moved = [this](double t) {
      return Pose3(Eigen::Translation3d(ahead_m, 0.0, 0.0) * way(t));
    };
    return scan(world, kLoamInputModel, moved, index++, start_s, 0.01);
  }
  OdometryEstimate process(const Sweep& sweep) {
    const OdometryEstimate e = odometry.process(sweep);
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

double loam_way_m(const OdometryEstimate& a, const OdometryEstimate& b) {
  return (b.T_odom_end.translation() - a.T_odom_end.translation()).norm();
}

}  // namespace

TEST_CASE("loam input: a gap is told and bridged") {
  LoamDrive d;
  d.drive(0, 10);
  const OdometryEstimate before = d.at(1.0);
  const OdometryEstimate after = d.at(2.0);
  CHECK(after.status == OdometryStatus::kRegistered);
  CHECK(after.cause == OdometryCause::kGap);
  CHECK(loam_way_m(before, after) == Approx(1.0).margin(0.05));
  CHECK(d.at(2.1).cause == OdometryCause::kNone);
  // Longer than velocity is trusted for: found again by looking around.
  const OdometryEstimate far = d.at(6.0);
  CHECK(far.cause == OdometryCause::kGap);
  CHECK(loam_way_m(before, far) == Approx(5.0).margin(0.1));
  d.drive(61, 65);
}

TEST_CASE("loam input: repeated, reversed and impossible times are refused") {
  LoamDrive d;
  d.drive(0, 10);
  const Sweep sweep = d.sweep_at(1.0);
  const OdometryEstimate first = d.process(sweep);
  const OdometryEstimate again = d.process(sweep);
  CHECK(again.status == OdometryStatus::kRefused);
  CHECK(again.cause == OdometryCause::kRepeatedTime);
  CHECK(again.T_odom_end.matrix() == first.T_odom_end.matrix());
  CHECK(d.at(0.5).cause == OdometryCause::kReversedTime);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Sweep broken = sweep;
  broken.start_time_s = nan;
  CHECK(d.process(broken).status == OdometryStatus::kRefused);
  broken = sweep;
  broken.start_azimuth_rad = nan;
  CHECK(d.process(broken).cause == OdometryCause::kNotFinite);
  d.drive(11, 14);
}

TEST_CASE("loam input: a scan of nothing, first or later, is predicted") {
  LoamDrive d;
  Sweep none;
  none.index = 77;
  CHECK(d.process(none).status == OdometryStatus::kPredicted);
  d.drive(1, 10);
  const OdometryEstimate before = d.at(1.0);
  none.start_time_s = 1.1;
  const OdometryEstimate empty = d.process(none);
  CHECK(empty.status == OdometryStatus::kPredicted);
  CHECK(empty.cause == OdometryCause::kEmptyScan);
  CHECK(empty.covariance(0, 0) > 100.0);
  CHECK(loam_way_m(before, empty) == Approx(0.1).margin(0.02));
  d.drive(12, 14);
}

TEST_CASE("loam input: few returns are few features") {
  LoamDrive d;
  d.drive(0, 5);
  Sweep sweep = d.sweep_at(0.5);
  sweep.returns.resize(40);
  for (Return& r : sweep.returns) r.range_ticks = 4000;
  const OdometryEstimate e = d.process(sweep);
  CHECK(e.status == OdometryStatus::kPredicted);
  CHECK(e.cause == OdometryCause::kFewFeatures);
  d.drive(6, 8);
}

TEST_CASE("loam input: blind for long, it stands still and goes on where it is") {
  LoamDrive d;
  d.drive(0, 5);
  OdometryEstimate e;
  for (int i = 0; i < 100; ++i) {
    Sweep none;
    none.start_time_s = 0.5 + 0.1 * i;
    none.index = i;
    e = d.process(none);
  }
  CHECK(e.T_odom_end.translation().norm() < 3.0);
}

TEST_CASE("loam input: a jump of 5 m is told, and the map found again") {
  LoamDrive d;
  d.drive(0, 20);
  const OdometryEstimate before = d.at(2.0);
  d.ahead_m = 5.0;
  const OdometryEstimate after = d.at(2.1);
  CHECK(after.cause == OdometryCause::kJump);
  CHECK(after.status == OdometryStatus::kRegistered);
  CHECK(loam_way_m(before, after) == Approx(5.1).margin(0.1));
  const OdometryEstimate next = d.at(2.2);
  CHECK(next.status == OdometryStatus::kRegistered);
  CHECK(next.cause == OdometryCause::kNone);
  CHECK(loam_way_m(after, next) == Approx(0.1).margin(0.05));
}

TEST_CASE("loam input: a jump out of the map is told, and what is there is the new map") {
  LoamDrive d;
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

TEST_CASE("loam input: returns that make no sense do no harm") {
  LoamDrive d;
  d.drive(0, 5);
  RandomStream random(11, "loam_input_noise");
  for (int i = 5; i < 10; ++i) {
    Sweep sweep = d.sweep_at(0.1 * i);
    for (Return& r : sweep.returns) {
      r.range_ticks = static_cast<std::uint16_t>(random.uniform(0.0, 65535.0));
      r.laser = static_cast<std::uint8_t>(random.uniform(0.0, 255.0));
      r.time_offset_ns = static_cast<std::uint32_t>(random.uniform(0.0, 4e9));
    }
    static_cast<void>(d.process(sweep));
  }
  static_cast<void>(d.at(1.0));
  d.drive(11, 15);
}
