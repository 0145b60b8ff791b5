#include <catch2/catch.hpp>

#include "algo/odometry/loam/loam.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;
using namespace honka::stem_world;

namespace {

const LidarModel kLoamModel = vlp16();

/// T_world_lidar: 1 m/s ahead while the body swings to and fro by 20° with 15°/s at most, and nods.
Pose3 loam_swing(double t) {
  const double yaw = deg_to_rad(20.0) * std::sin(0.75 * t);
  return pose_from_rpy({1.0 * t - 4.0, 0.0, 1.5 + 0.02 * std::sin(3.0 * t)},
                       deg_to_rad(0.5) * std::sin(4.0 * t), deg_to_rad(0.5) * std::sin(5.0 * t),
                       yaw);
}

std::vector<OdometryEstimate> loam_run(const World& world, const Way& way, int sweeps,
                                       const LoamSettings& settings = {}, double noise_m = 0.01) {
  LoamOdometry odometry(kLoamModel, settings);
  std::vector<OdometryEstimate> estimates;
  for (int i = 0; i < sweeps; ++i) {
    estimates.push_back(odometry.process(scan(world, kLoamModel, way, i, 0.1 * i, noise_m)));
  }
  return estimates;
}

/// What the estimates at a and b say of the way between, against the truth, as a twist.
Twist loam_error(const OdometryEstimate& a, const OdometryEstimate& b, const Way& way) {
  const Pose3 estimated = a.T_odom_start.inverse() * b.T_odom_end;
  const Pose3 truth = way(a.start_time_s).inverse() * way(b.end_time_s);
  return se3_log(truth.inverse() * estimated);
}

}  // namespace

TEST_CASE("loam: a swinging drive is recovered") {
  const auto run = loam_run(stand(), loam_swing, 40);
  for (const OdometryEstimate& e : run) {
    CHECK(e.status == OdometryStatus::kRegistered);
    CHECK(e.cause == OdometryCause::kNone);
    if (e.sweep == 0) continue;  // its own motion shows with the next one
    const Twist error = loam_error(run.front(), e, loam_swing);
    CHECK(error.head<3>().norm() < 0.06);
    CHECK(error.tail<3>().norm() < deg_to_rad(0.4));
    CHECK(e.covariance.diagonal().head<3>().maxCoeff() < 1e-3);
  }
}

TEST_CASE("loam: the same sweeps twice give the same digits") {
  const auto a = loam_run(stand(3), loam_swing, 12), b = loam_run(stand(3), loam_swing, 12);
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].T_odom_start.matrix() == b[i].T_odom_start.matrix());
    CHECK(a[i].T_odom_end.matrix() == b[i].T_odom_end.matrix());
    CHECK(a[i].covariance == b[i].covariance);
  }
}

TEST_CASE("loam: at rest it rests") {
  const Way rest = [](double) { return pose_from_rpy({0, 0, 1.5}, 0.0, 0.0, 0.3); };
  const auto run = loam_run(stand(3), rest, 15);
  CHECK(run.front().T_odom_start.translation().norm() == 0.0);
  for (const OdometryEstimate& e : run) {
    CHECK(loam_error(run.front(), e, rest).head<3>().norm() < 0.01);
    CHECK(loam_error(run.front(), e, rest).tail<3>().norm() < deg_to_rad(0.1));
  }
}

TEST_CASE("loam: a drive that is under way at the first sweep has its scale") {
  const Twist per_second = (Twist() << 2.0, 0, 0, 0, 0, deg_to_rad(15.0)).finished();
  const Way way = steady(pose_from_rpy({-6, 0, 1.5}, 0, 0, -0.2), per_second);
  const auto run = loam_run(stand(), way, 20);
  for (std::size_t i = 1; i < run.size(); ++i) {
    CHECK(loam_error(run[1], run[i], way).head<3>().norm() < 0.05);
    CHECK(loam_error(run[1], run[i], way).tail<3>().norm() < deg_to_rad(0.3));
    if (i > 1) {
      const Pose3 way_back = way(run[0].start_time_s).inverse() * way(run[i].start_time_s);
      CHECK((run[i].T_odom_start.translation() - way_back.translation()).norm() < 0.08);
    }
  }
}

TEST_CASE("loam: the first pose is level on a slope, by the stems") {
  for (const double pitch_deg : {-6.0, -16.0}) {
    World world = stand(5, 0.02);
    world.slope = {std::tan(deg_to_rad(-pitch_deg)), -0.05};
    const Pose3 tilted = pose_from_rpy({0, 0, 1.5}, deg_to_rad(4.0), deg_to_rad(pitch_deg), 0.0);
    const auto run = loam_run(
        world, [&](double) { return tilted; }, 1);
    const Eigen::Vector3d up_in_odom =
        run[0].T_odom_start.linear() * tilted.linear().transpose() * Eigen::Vector3d::UnitZ();
    CHECK(std::acos(std::min(1.0, up_in_odom.z())) < deg_to_rad(0.6));
    CHECK(run[0].T_odom_start.translation().norm() == 0.0);
    CHECK(std::abs(yaw_of(run[0].T_odom_start)) < 1e-9);
  }
}

TEST_CASE("loam: the crane that swings in view does not pull") {
  // A boom from 4 to 9 m ahead that moves with the lidar, in front of the stand.
  const World world = stand();
  LoamOdometry odometry(kLoamModel, {});
  std::vector<OdometryEstimate> run;
  for (int i = 0; i < 30; ++i) {
    Sweep sweep = scan(world, kLoamModel, loam_swing, i, 0.1 * i, 0.01);
    for (Return& r : sweep.returns) {
      const double azimuth = wrap_to_pi(sweep.azimuth_rad(r, kLoamModel));
      for (int bar = 0; bar < 5; ++bar) {
        if (std::abs(azimuth - 0.15 * bar + 0.3) < 0.012) {
          r.range_ticks = static_cast<std::uint16_t>((4.0 + bar) / 0.002);
        }
      }
    }
    run.push_back(odometry.process(sweep));
    if (i == 0) continue;
    const Twist error = loam_error(run.front(), run.back(), loam_swing);
    CHECK(error.head<3>().norm() < 0.08);
    CHECK(error.tail<3>().norm() < deg_to_rad(0.4));
  }
}

TEST_CASE("loam: the map stays within its bound and the drive goes on") {
  LoamSettings settings;
  settings.map.most_voxels = 1000;
  LoamOdometry odometry(kLoamModel, settings);
  const World world = stand(8);
  OdometryEstimate first, last;
  for (int i = 0; i < 60; ++i) {
    last = odometry.process(scan(world, kLoamModel, loam_swing, i, 0.1 * i, 0.01));
    if (i == 0) first = last;
    CHECK(odometry.map().edges.size() <= 1000);
    CHECK(odometry.map().planes.size() <= 1000);
  }
  CHECK(loam_error(first, last, loam_swing).head<3>().norm() < 0.15);
}

TEST_CASE("loam: on bare ground x, y and yaw are told to be unobserved") {
  World bare;
  const Way rest = [](double) { return pose_from_rpy({0, 0, 1.5}, 0.0, 0.0, 0.0); };
  const auto run = loam_run(bare, rest, 10);
  for (std::size_t i = 1; i < run.size(); ++i) {
    CHECK(run[i].status == OdometryStatus::kDegenerate);
    CHECK(run[i].cause == OdometryCause::kUnobserved);
    CHECK(run[i].T_odom_end.translation().norm() < 0.05);
    CHECK(run[i].covariance(0, 0) > 10.0);
    CHECK(run[i].covariance(1, 1) > 10.0);
    CHECK(run[i].covariance(2, 2) < 0.01);
  }
}
