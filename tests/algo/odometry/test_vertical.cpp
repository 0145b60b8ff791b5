#include <catch2/catch.hpp>

#include "algo/odometry/stems/vertical.h"
#include "tests/algo/odometry/stem_world.h"

using namespace honka;
using namespace honka::stem_world;

namespace {

const LidarModel kVerticalModel = vlp16();

VerticalEstimate vertical_of(const World& world, const Pose3& T_world_lidar, double noise_m = 0.0) {
  const Sweep sweep = scan(
      world, kVerticalModel, [&](double) { return T_world_lidar; }, 0, 0.0, noise_m);
  const PosedSweep still{&sweep, Pose3::Identity(), Pose3::Identity()};
  return estimate_vertical({&still, 1}, kVerticalModel);
}

double error_deg(const VerticalEstimate& vertical, const Pose3& T_world_lidar) {
  const Eigen::Vector3d up = T_world_lidar.linear().row(2).transpose();
  return rad_to_deg(std::acos(std::min(1.0, vertical.up.dot(up))));
}

}  // namespace

TEST_CASE("vertical: upright stems give the tilt of the lidar whatever the ground does") {
  World world = stand();
  world.slope = {0.08, -0.05};
  for (const double roll_deg : {-6.0, 0.0, 4.0}) {
    for (const double pitch_deg : {-5.0, 0.0, 7.0}) {
      const Pose3 T_world_lidar =
          pose_from_rpy({0.0, 0.0, 1.5}, deg_to_rad(roll_deg), deg_to_rad(pitch_deg), 0.7);
      const VerticalEstimate vertical = vertical_of(world, T_world_lidar);
      CHECK(vertical.source == VerticalSource::kStems);
      CHECK(vertical.stems > 20);
      CHECK(error_deg(vertical, T_world_lidar) < 0.15);
      CHECK(vertical.up.norm() == Approx(1.0));
    }
  }
}

TEST_CASE("vertical: a view to one side of stems that taper does not lean") {
  // Uncorrected: 0.785 · 0.02 · sin 105°/(105 π/180), 0.47° away from the view.
  World world = stand();
  for (Trunk& trunk : world.trunks) {
    trunk.radius_m += 0.08;
    trunk.taper = 0.02;
  }
  const Pose3 T_world_lidar = pose_from_rpy({0.0, 0.0, 1.5}, 0.02, 0.01, 0.3);
  CHECK(error_deg(vertical_of(world, T_world_lidar), T_world_lidar) < 0.2);
}

TEST_CASE("vertical: leaning trees average out, and the claimed s.d. covers the error") {
  double squares = 0.0;
  constexpr int kStands = 20;
  for (std::uint64_t seed = 1; seed <= kStands; ++seed) {
    const Pose3 T_world_lidar = pose_from_rpy({0.0, 0.0, 1.5}, 0.03, -0.05, 0.1);
    const VerticalEstimate vertical = vertical_of(stand(5, 0.04, seed), T_world_lidar, 0.01);
    CHECK(error_deg(vertical, T_world_lidar) < 1.5);
    squares += std::pow(error_deg(vertical, T_world_lidar) / rad_to_deg(vertical.sigma_rad), 2);
  }
  // Two axes: the mean square in units of the s.d. is 2; chi-square with 40 degrees of freedom.
  CHECK(squares / kStands > 0.8);
  CHECK(squares / kStands < 4.0);
}

TEST_CASE("vertical: several sweeps of a moving lidar, each stem once") {
  const World world = stand(5, 0.03, 4);
  Twist per_second;
  per_second << 1.0, 0.0, 0.0, 0.0, 0.0, 0.25;
  const Pose3 T_world_start = pose_from_rpy({0.0, 0.0, 1.5}, 0.05, 0.02, 0.0);
  const Way way = steady(T_world_start, per_second);
  std::vector<Sweep> sweeps;
  for (int i = 0; i < 8; ++i) sweeps.push_back(scan(world, kVerticalModel, way, i, 0.1 * i, 0.01));
  std::vector<PosedSweep> posed;
  for (const Sweep& s : sweeps) {
    posed.push_back({&s, T_world_start.inverse() * way(s.start_time_s),
                     T_world_start.inverse() * way(s.start_time_s + 0.1)});
  }
  const VerticalEstimate one = estimate_vertical(std::span(posed).first(1), kVerticalModel);
  const VerticalEstimate all = estimate_vertical(posed, kVerticalModel);
  CHECK(all.stems >= one.stems);
  CHECK(all.stems <= static_cast<std::int64_t>(world.trunks.size()));
  CHECK(error_deg(all, T_world_start) < 1.0);
  CHECK(all.sigma_rad < deg_to_rad(1.0));
}

TEST_CASE("vertical: without stems the ground's normal, without ground z") {
  World bare;
  bare.slope = {0.05, 0.02};
  const Pose3 T_world_lidar = pose_from_rpy({0.0, 0.0, 1.5}, 0.04, -0.03, 1.0);
  const VerticalEstimate ground = vertical_of(bare, T_world_lidar);
  CHECK(ground.source == VerticalSource::kGround);
  const Eigen::Vector3d normal =
      T_world_lidar.linear().transpose() * Eigen::Vector3d(-0.05, -0.02, 1.0).normalized();
  CHECK(ground.up.dot(normal) > std::cos(deg_to_rad(0.1)));
  CHECK(ground.sigma_rad == Approx(deg_to_rad(VerticalSettings{}.ground_slope_deg)));

  World nothing;
  nothing.ground = false;
  const VerticalEstimate assumed = vertical_of(nothing, T_world_lidar);
  CHECK(assumed.source == VerticalSource::kAssumed);
  CHECK(assumed.up == Eigen::Vector3d::UnitZ());
  CHECK(assumed.sigma_rad > 0.5);
}

TEST_CASE("vertical: a levelled start has z up and x along the heading") {
  for (const double roll : {-0.3, 0.0, 0.1}) {
    for (const double pitch : {-0.2, 0.0, 0.25}) {
      const Pose3 T_odom_lidar = pose_from_rpy(Eigen::Vector3d::Zero(), roll, pitch, 0.0);
      const Pose3 start = levelled_start(T_odom_lidar.linear().row(2).transpose());
      CHECK(start.isApprox(T_odom_lidar, 1e-12));
      CHECK(yaw_of(start) == Approx(0.0).margin(1e-12));
    }
  }
}
