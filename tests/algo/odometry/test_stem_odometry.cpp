#include <catch2/catch.hpp>

#include "algo/odometry/stems/stem_odometry.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;
using namespace honka::stem_world;

namespace {

const LidarModel kStemModel = vlp16();
constexpr double kPeriod_s = 0.1;

Twist twist_of(double forward_m_s, double yaw_rad_s) {
  Twist twist = Twist::Zero();
  twist(0) = forward_m_s;
  twist(5) = yaw_rad_s;
  return twist;
}

Pose3 stem_start(double yaw_rad = 0.0) {
  return pose_from_rpy({-8.0, 0.0, 1.5}, 0.03, -0.04, yaw_rad);
}

/// Truth in the frame of the odometry: origin and heading of the first sweep's start, z up.
Pose3 T_odom_lidar_true(const Way& way, double time_s) {
  const Pose3 T_world_first = way(0.0);
  const Pose3 T_world_odom =
      pose_from_rpy(T_world_first.translation(), 0.0, 0.0, yaw_of(T_world_first));
  return T_world_odom.inverse() * way(time_s);
}

std::vector<OdometryEstimate> run(StemOdometry& odometry, const World& world, const Way& way,
                                  int sweeps, double noise_m = 0.0) {
  std::vector<OdometryEstimate> estimates;
  for (int i = 0; i < sweeps; ++i) {
    estimates.push_back(odometry.process(scan(world, kStemModel, way, i, kPeriod_s * i, noise_m)));
    CHECK(estimates.back().T_odom_end.matrix().allFinite());
    CHECK(estimates.back().covariance.allFinite());
  }
  return estimates;
}

void check_near(const Pose3& T_a, const Pose3& T_b, double way_m, double turn_deg) {
  const Twist difference = se3_log(T_a.inverse() * T_b);
  CHECK(difference.head<3>().norm() < way_m);
  CHECK(rad_to_deg(difference.tail<3>().norm()) < turn_deg);
}

}  // namespace

TEST_CASE("stems: a drive, a swing and a stand are recovered") {
  const World world = stand();
  for (const Twist& twist : {twist_of(1.0, 0.0), twist_of(0.6, 0.26), twist_of(0.0, -0.26),
                             twist_of(0.0, 0.0), twist_of(-1.0, 0.05)}) {
    const Way way = steady(stem_start(), twist);
    StemOdometry odometry(kStemModel, {});
    const auto estimates = run(odometry, world, way, 40, 0.01);
    for (const OdometryEstimate& e : estimates) {
      CHECK(e.status == OdometryStatus::kRegistered);
      CHECK(e.cause == OdometryCause::kNone);
    }
    // Between two sweeps of the drive, so that the error of the start is not in it.
    const Pose3 estimated = estimates[10].T_odom_end.inverse() * estimates[39].T_odom_end;
    const Pose3 truth = way(1.1).inverse() * way(4.0);
    check_near(estimated, truth, 0.05, 0.3);
    check_near(estimates[39].T_odom_end, T_odom_lidar_true(way, 4.0), 0.15, 1.0);
  }
}

TEST_CASE("stems: the motion within the sweep is compensated") {
  // At 30°/s a stem at 20 m moves by 0.5 m between the first and the last firing of 210°; a turn to
  // and fro bends the stand to either side.
  const World world = stand();
  const Way way = [](double t) -> Pose3 {
    return pose_from_rpy({-4.0, 0.0, 1.5}, 0.0, 0.0, 0.5 * std::sin(t));
  };
  StemOdometry odometry(kStemModel, {});
  const auto estimates = run(odometry, world, way, 50);
  for (std::size_t i = 5; i < estimates.size(); ++i) {
    const double end_s = 0.1 * static_cast<double>(i + 1);
    check_near(estimates[i].T_odom_end, T_odom_lidar_true(way, end_s), 0.03, 0.3);
  }
}

TEST_CASE("stems: the covariance covers the error from sweep to sweep") {
  const World world = stand();
  const Way way = steady(stem_start(), twist_of(0.5, 0.1));
  StemOdometry odometry(kStemModel, {});
  const auto estimates = run(odometry, world, way, 60, 0.02);
  for (std::size_t i = 20; i < estimates.size(); ++i) {
    const Covariance6& c = estimates[i].covariance;
    CHECK(c.isApprox(c.transpose()));
    CHECK(c.ldlt().isPositive());
    const Twist error = se3_log(
        (estimates[i - 1].T_odom_end.inverse() * estimates[i].T_odom_end).inverse() *
        (way(0.1 * static_cast<double>(i)).inverse() * way(0.1 * static_cast<double>(i + 1))));
    CHECK(error.head<2>().norm() < 6.0 * std::sqrt(c(0, 0) + c(1, 1)));
    CHECK(std::sqrt(c(0, 0)) < 0.05);
  }
}

TEST_CASE("stems: the same digits from the same sweeps") {
  const World world = stand();
  const Way way = steady(stem_start(), twist_of(0.8, 0.2));
  StemOdometry one(kStemModel, {}), two(kStemModel, {});
  const auto a = run(one, world, way, 15, 0.01), b = run(two, world, way, 15, 0.01);
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].T_odom_end.matrix() == b[i].T_odom_end.matrix());
    CHECK(a[i].covariance == b[i].covariance);
  }
}

TEST_CASE("stems: a world turned about the vertical gives the same way") {
  const World world = stand(5, 0.02);
  const Way way = steady(stem_start(), twist_of(0.8, 0.2));
  StemOdometry odometry(kStemModel, {});
  const auto reference = run(odometry, world, way, 25);
  for (const double yaw : {0.5, 2.0, -3.0}) {
    Pose3 turn = Pose3::Identity();
    turn.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    StemOdometry other(kStemModel, {});
    const auto estimates = run(
        other, turned(world, yaw), [&](double t) -> Pose3 { return turn * way(t); }, 25);
    // Ranges are rounded to 2 mm after the turn: a tick may differ.
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      check_near(estimates[i].T_odom_end, reference[i].T_odom_end, 1e-3, 0.01);
    }
  }
}

TEST_CASE("stems: a place seen before is the same place") {
  const World world = stand(6);
  const double turn_rad_s = 0.5;
  const Pose3 T_world_start = pose_from_rpy({0.0, 0.0, 1.5}, 0.0, 0.0, 0.0);
  const Way way = steady(T_world_start, twist_of(2.0 * turn_rad_s, turn_rad_s));  // 2 m of radius
  const double lap_s = 2.0 * kPi / turn_rad_s;
  StemOdometry odometry(kStemModel, {});
  const auto estimates = run(odometry, world, way, static_cast<int>(lap_s / kPeriod_s) + 5, 0.01);
  const auto i = static_cast<std::size_t>(lap_s / kPeriod_s);
  check_near(estimates[i].T_odom_end, T_odom_lidar_true(way, 0.1 * static_cast<double>(i + 1)),
             0.10, 1.0);
}

TEST_CASE("stems: what moves with the machine or beside it does not lead it astray") {
  const World standing = stand();
  const Way way = steady(stem_start(), twist_of(0.8, 0.0));
  StemOdometry odometry(kStemModel, {});
  std::vector<OdometryEstimate> estimates;
  for (int i = 0; i < 40; ++i) {
    World world = standing;  // a log in the crane: 5 m ahead all the time, swaying
    Trunk load;
    load.foot_m = (way(0.1 * i) * Eigen::Vector3d(5.0, std::sin(0.3 * i), 0.0)).head<2>();
    world.trunks.push_back(load);
    estimates.push_back(odometry.process(scan(world, kStemModel, way, i, 0.1 * i, 0.01)));
    CHECK(estimates.back().status == OdometryStatus::kRegistered);
  }
  check_near(estimates[5].T_odom_end.inverse() * estimates[39].T_odom_end,
             way(0.6).inverse() * way(4.0), 0.05, 0.3);
}

TEST_CASE("stems: memory is bounded by its settings") {
  StemOdometrySettings settings;
  settings.landmarks.max_landmarks = 60;
  const World world = stand(7);
  const Way way = steady(pose_from_rpy({-25.0, 0.0, 1.5}, 0, 0, 0), twist_of(5.0, 0.0));
  StemOdometry odometry(kStemModel, settings);
  for (int i = 0; i < 80; ++i) {
    const auto e = odometry.process(scan(world, kStemModel, way, i, 0.1 * i));
    CHECK(odometry.landmarks() <= 60);
    CHECK(e.T_odom_end.matrix().allFinite());
  }
}
