#include "sim/harvester/vehicle.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "sim/harvester/paths.h"

namespace honka::sim {
namespace {

/// Ground that rises by `gradient` per metre.
Heightfield plane(const Eigen::Vector2d& gradient) {
  constexpr int kNodes = 101;
  std::vector<double> heights;
  for (int iy = 0; iy < kNodes; ++iy) {
    for (int ix = 0; ix < kNodes; ++ix) {
      heights.push_back(gradient.dot(Eigen::Vector2d(4.0 * ix - 200.0, 4.0 * iy - 200.0)));
    }
  }
  return {{-200.0, -200.0}, 4.0, kNodes, kNodes, heights};
}

VehicleSettings stiff(bool work_cycle) {
  VehicleSettings settings;
  settings.suspension_noise_deg = 0.0;
  settings.work_cycle = work_cycle;
  return settings;
}

}  // namespace

TEST_CASE("on a plane slope the body stands at right angles to the ground") {
  const Eigen::Vector2d gradient(0.1, -0.05);
  const Vehicle vehicle({{-20, 0}, {20, 10}}, plane(gradient), stiff(true), 5);
  const Eigen::Vector3d normal = Eigen::Vector3d(-gradient.x(), -gradient.y(), 1).normalized();
  const Trajectory& truth = vehicle.trajectory();
  for (double t = 0.0; t < truth.duration_s(); t += 0.37) {
    const Pose3 pose = truth.T_world_lidar(t);
    CHECK((pose.linear().col(2) - normal).norm() < 1e-6);
    const Eigen::Vector3d foot = pose.translation() - 1.5 * normal;
    CHECK(foot.z() == Approx(gradient.dot(foot.head<2>())).margin(1e-6));
  }
}

TEST_CASE("truth is continuous in place and speed, and keeps the limits") {
  VehicleSettings settings;
  const Vehicle vehicle(work_path({Eigen::Vector2d(-60, -60), Eigen::Vector2d(60, 60)}, 30.0, 3),
                        plane({0.05, 0.02}), settings, 3);
  const Trajectory& truth = vehicle.trajectory();
  constexpr double kStep_s = 0.002;
  double last_yaw = yaw_of(truth.T_world_lidar(0.0)), last_travelled = 0.0;
  Eigen::Vector3d last = truth.T_world_lidar(0.0).translation(), last_velocity(0, 0, 0);
  double most_swing = 0.0;
  for (double t = kStep_s; t < truth.duration_s(); t += kStep_s) {
    const Pose3 pose = truth.T_world_lidar(t);
    const Eigen::Vector3d velocity = (pose.translation() - last) / kStep_s;
    const double turn_rate = wrap_to_pi(yaw_of(pose) - last_yaw) / kStep_s;
    const double speed = (vehicle.travelled_m(t) - last_travelled) / kStep_s;
    REQUIRE(speed >= -1e-9);
    REQUIRE(speed <= settings.drive_speed_m_s + 1e-6);
    REQUIRE(std::fabs(turn_rate) < deg_to_rad(settings.swing_rate_deg_s) + 0.15);
    if (t > 1.5 * kStep_s) REQUIRE((velocity - last_velocity).norm() < 0.01);
    most_swing = std::max(most_swing, std::fabs(vehicle.plan().swing_rad(t)));
    last = pose.translation();
    last_velocity = velocity;
    last_yaw = yaw_of(pose);
    last_travelled = vehicle.travelled_m(t);
  }
  CHECK(last_travelled == Approx(30.0).margin(1e-3));
  CHECK(most_swing > deg_to_rad(settings.least_swing_deg));
  CHECK(most_swing <= deg_to_rad(settings.most_swing_deg));
}

TEST_CASE("the lidar rides ahead of the joint, and swings about it while the machine stands") {
  const Vehicle vehicle({{0, 0}, {50, 0}}, plane({0, 0}), stiff(true), 9);
  const Trajectory& truth = vehicle.trajectory();
  double widest = 0.0;
  for (double t = 0.0; t < truth.duration_s(); t += 0.11) {
    const Pose3 pose = truth.T_world_lidar(t);
    const double yaw = yaw_of(pose), along = vehicle.travelled_m(t);
    const Eigen::Vector3d expected(along + 2.2 * std::cos(yaw), 2.2 * std::sin(yaw), 1.5);
    CHECK((pose.translation() - expected).norm() < 1e-3);
    CHECK(yaw == Approx(vehicle.joint_angle_rad(t)).margin(1e-4));
    widest = std::max(widest, std::fabs(yaw));
  }
  CHECK(widest > deg_to_rad(45.0));
}

TEST_CASE("a tilted mounting tilts the lidar, springs shake it as much as asked") {
  VehicleSettings settings = stiff(false);
  settings.mount_pitch_deg = 5.0;
  const Vehicle tilted({{0, 0}, {20, 0}}, plane({0, 0}), settings, 9);
  const Pose3 pose = tilted.trajectory().T_world_lidar(7.0);
  CHECK(pose.linear()(2, 0) == Approx(-std::sin(deg_to_rad(5.0))).margin(1e-9));
  settings.mount_pitch_deg = 0.0;
  settings.suspension_noise_deg = 0.4;
  const Vehicle shaken({{0, 0}, {190, 0}}, plane({0, 0}), settings, 9);
  double squares = 0.0, count = 0.0;
  for (double t = 0.0; t < shaken.duration_s(); t += 0.05, count += 1.0) {
    squares += std::pow(shaken.trajectory().T_world_lidar(t).linear()(2, 0), 2);
  }
  CHECK(rad_to_deg(std::sqrt(squares / count)) == Approx(0.4).epsilon(0.15));
}

TEST_CASE("the same seed drives the same way, another seed another") {
  const Polyline path = {{0, 0}, {30, 5}};
  const Heightfield ground = plane({0.03, 0.01});
  const Vehicle a(path, ground, {}, 4), b(path, ground, {}, 4), c(path, ground, {}, 5);
  CHECK(a.trajectory().T_world_lidar(33.3).matrix() == b.trajectory().T_world_lidar(33.3).matrix());
  CHECK(a.trajectory().duration_s() != c.trajectory().duration_s());
}

TEST_CASE("crane and tree ride in the lidar frame, the tree only while it is processed") {
  VehicleSettings settings = stiff(true);
  const Vehicle vehicle({{0, 0}, {30, 0}}, plane({0, 0}), settings, 4);
  for (const Phase& phase : vehicle.plan().phases()) {
    const auto cones = vehicle.occluders_in_lidar(phase.start_s + 0.5 * phase.duration_s);
    int logs = 0;
    for (const Cone& cone : cones) {
      logs += cone.label.part == Part::kLog ? 1 : 0;
      CHECK((cone.label.part == Part::kLog || cone.label.part == Part::kMachine));
      // Nothing of it touches the sensor; the crane stands ahead of it.
      CHECK(std::max(cone.a_m.norm(), cone.b_m.norm()) > 0.5);
      if (cone.label.part == Part::kMachine) CHECK(cone.a_m.x() > 0.0);
    }
    CHECK(logs == (phase.task == Task::kProcess ? 1 : 0));
  }
  settings.occluders = false;
  CHECK(Vehicle({{0, 0}, {30, 0}}, plane({0, 0}), settings, 4).occluders_in_lidar(3.0).empty());
}

TEST_CASE("strip roads of 200 by 300 m make the preprint's 1,200 m") {
  const Eigen::AlignedBox2d extent(Eigen::Vector2d(0, 0), Eigen::Vector2d(200, 300));
  const auto roads = strip_roads(extent, 50.0);
  REQUIRE(roads.size() == 4);
  double total = 0.0;
  for (const Polyline& road : roads) total += length_m(road);
  CHECK(total == Approx(1200.0));
  // Three turns: half a circle of 10 m and 30 m across.
  CHECK(length_m(prior_run_path(extent, 50.0)) ==
        Approx(1200.0 + 3 * (kPi * 10.0 + 30.0)).margin(0.2));
}

}  // namespace honka::sim
