#include <catch2/catch.hpp>

#include "algo/geometry/se3.h"
#include "algo/odometry/track.h"

using namespace honka;

namespace {

Pose3 track_pose(double x_m, double yaw_rad = 0.0) {
  return pose_from_rpy({x_m, 0.0, 0.0}, 0.0, 0.0, yaw_rad);
}

OdometryEstimate track_estimate(double start_s, const Pose3& start, const Pose3& end) {
  OdometryEstimate e;
  e.start_time_s = start_s;
  e.end_time_s = start_s + 0.1;
  e.T_odom_start = start;
  e.T_odom_end = end;
  return e;
}

/// Sweeps at 0, 0.1 and, after a gap, 0.4 s at 1 m/s.
OdometryTrack track_with_gap() {
  OdometryTrack track;
  for (const double t : {0.0, 0.1, 0.4}) {
    track.add(track_estimate(t, track_pose(t), track_pose(t + 0.1)));
  }
  return track;
}

}  // namespace

TEST_CASE("a track answers within sweeps, across gaps, and beyond its ends") {
  const OdometryTrack track = track_with_gap();
  for (const double t : {0.0, 0.03, 0.1, 0.17, 0.2, 0.3, 0.4, 0.45, 0.5}) {
    CHECK(track.T_odom_lidar(t).translation().x() == Approx(t).margin(1e-12));
  }
  CHECK(track.T_odom_lidar(-3.0).translation().x() == 0.0);
  CHECK(track.T_odom_lidar(9.0).translation().x() == Approx(0.5));
}

TEST_CASE("body twist is constant within a sweep") {
  Twist twist;
  twist << 0.1, 0.0, 0.0, 0.0, 0.0, 0.4;
  OdometryTrack track;
  track.add(track_estimate(0.0, track_pose(1.0), track_pose(1.0) * se3_exp(twist)));
  const Pose3 expected = track_pose(1.0) * se3_exp(0.3 * twist);
  CHECK(track.T_odom_lidar(0.03).isApprox(expected, 1e-12));
}

TEST_CASE("at() is the sweep that a time falls into, or the last one before it") {
  const OdometryTrack track = track_with_gap();
  CHECK(track.at(-1.0).start_time_s == 0.0);
  CHECK(track.at(0.05).start_time_s == 0.0);
  CHECK(track.at(0.1).start_time_s == 0.1);
  CHECK(track.at(0.35).start_time_s == 0.1);
  CHECK(track.at(7.0).start_time_s == 0.4);
}

TEST_CASE("refused sweeps are left out of a track") {
  OdometryTrack track = track_with_gap();
  OdometryEstimate refused = track_estimate(0.1, track_pose(50.0), track_pose(50.0));
  refused.status = OdometryStatus::kRefused;
  track.add(refused);
  CHECK(track.estimates().size() == 3);
}

TEST_CASE("sweeps that overlap by rounding meet without a step back in time") {
  OdometryTrack track;
  OdometryEstimate first = track_estimate(0.0, track_pose(0.0), track_pose(0.1));
  first.end_time_s = 0.1 + 1e-12;
  track.add(first);
  track.add(track_estimate(0.1, track_pose(0.1), track_pose(0.2)));
  CHECK(track.T_odom_lidar(0.1).translation().x() == Approx(0.1));
  CHECK(track.T_odom_lidar(0.15).translation().x() == Approx(0.15));
}

TEST_CASE("The planar covariance of an estimate is along the levelled axes of the lidar") {
  OdometryEstimate estimate;
  estimate.covariance.setZero();
  estimate.covariance.diagonal() << 4.0, 1.0, 9.0, 0.1, 0.2, 0.3;
  // Yaw alone: the axes turn with the lidar.
  estimate.T_odom_end = pose_from_rpy({7.0, 8.0, 9.0}, 0.0, 0.0, 2.0);
  const Eigen::Matrix3d level = planar_covariance(estimate);
  CHECK(level.isApprox(Eigen::Vector3d(4.0, 1.0, 0.3).asDiagonal().toDenseMatrix()));
  // On its side, the lidar's z lies in the plane and its y is the axis of yaw.
  estimate.T_odom_end = pose_from_rpy({0.0, 0.0, 0.0}, kPi / 2.0, 0.0, 2.0);
  const Eigen::Matrix3d tilted = planar_covariance(estimate);
  CHECK(tilted.isApprox(Eigen::Vector3d(4.0, 9.0, 0.2).asDiagonal().toDenseMatrix()));
}
