#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/lidar/sweep_poses.h"
#include "tests/sim/lidar/quiet_sensor.h"

namespace honka::sim {
namespace {

/// Drives along x and turns about z, both evenly.
class EvenMotion : public Trajectory {
 public:
  EvenMotion(double speed_m_s, double turn_rad_s) : speed_(speed_m_s), turn_(turn_rad_s) {}
  [[nodiscard]] double duration_s() const override { return 1e6; }
  [[nodiscard]] Pose3 T_world_lidar(double t) const override {
    return pose_from_rpy({speed_ * t, 0, 1.5}, 0.02, -0.01, turn_ * t);
  }

 private:
  double speed_, turn_;
};

/// As wild as the machine gets: swings, and shakes on its springs.
class WildMotion : public Trajectory {
 public:
  [[nodiscard]] double duration_s() const override { return 1e6; }
  [[nodiscard]] Pose3 T_world_lidar(double t) const override {
    return pose_from_rpy({std::sin(t), 0.5 * t, 0.1 * std::cos(5 * t)}, 0.01 * std::sin(9 * t),
                         0.01 * std::cos(8 * t), 0.7 * std::sin(0.4 * t));
  }
};

}  // namespace

TEST_CASE("blended poses agree with the exact ones to 1e-7 rad and a micrometre") {
  const WildMotion motion;
  const SweepPoses poses(motion, 2.0, 0.1);
  for (int i = 0; i <= 20000; ++i) {
    const double offset = 0.1 * i / 20000.0;
    const SweepPoses::Matrix34 m = poses.at(offset);
    const Pose3 exact = motion.T_world_lidar(2.0 + offset);
    for (const Eigen::Vector3d& d : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0.6, 0, 0.8)}) {
      const Ray ray = to_world(m, {0, 0, 0, d.x(), d.y(), d.z()});
      CHECK((Eigen::Vector3d(ray.dx, ray.dy, ray.dz) - exact.linear() * d).norm() < 1e-7);
      CHECK((Eigen::Vector3d(ray.ox, ray.oy, ray.oz) - exact.translation()).norm() < 1e-6);
    }
  }
}

TEST_CASE("every return of a moving sensor lies on the ring, at the time of its own shot") {
  World world;
  world.cones.push_back({{0, 0, -40}, {0, 0, 40}, 30.0, 30.0, {-1, Part::kWall}});
  const LidarSimulator lidar(world, quiet_sensor(), 1);
  const EvenMotion motion(1.5, deg_to_rad(20.0));
  double frozen_worst = 0.0;
  for (const std::int64_t index : {0, 7, 31}) {
    const TruthfulSweep result = lidar.cast(motion, index);
    const Pose3 frozen = motion.T_world_lidar(result.sweep.start_time_s);
    for (const Return& r : result.sweep.returns) {
      const Eigen::Vector3d p = result.sweep.point_in_lidar(r, lidar.model());
      const Eigen::Vector3d in_world = motion.T_world_lidar(result.sweep.time_s(r)) * p;
      // Half a tick along the beam.
      CHECK(std::fabs(in_world.head<2>().norm() - 30.0) < 0.0011);
      frozen_worst = std::max(frozen_worst, std::fabs((frozen * p).head<2>().norm() - 30.0));
    }
  }
  CHECK(frozen_worst > 0.05);
}

TEST_CASE("firings keep the manual's clock, laser order and azimuth step") {
  World world;
  LidarSettings settings = quiet_sensor();
  settings.field_of_view_deg = 360.0;
  const LidarSimulator lidar(world, settings, 1);
  const StaticTrajectory still(Pose3::Identity(), 1.0);
  std::int64_t last_ns = -1;
  for (const std::int64_t index : {0, 1, 2}) {
    const Sweep sweep = lidar.cast(still, index).sweep;
    CHECK(sweep.start_time_s == Approx(0.1 * static_cast<double>(index)));
    CHECK(sweep.start_azimuth_rad == -kPi);
    for (std::size_t i = 0; i < sweep.returns.size(); ++i) {
      REQUIRE(sweep.returns[i].laser == i % 16);
      const std::int64_t ns = 100'000'000 * index + sweep.returns[i].time_offset_ns;
      // Within a firing 2.304 µs; to the next firing what is left of 55.296 µs: also over sweeps.
      const std::int64_t step = i % 16 == 0 ? 55'296 - 15 * 2'304 : 2'304;
      if (last_ns >= 0) REQUIRE(std::abs(ns - last_ns - step) <= 1);
      last_ns = ns;
    }
    const double azimuth_step = sweep.azimuth_rad(sweep.returns[16], lidar.model()) -
                                sweep.azimuth_rad(sweep.returns[0], lidar.model());
    CHECK(rad_to_deg(azimuth_step) == Approx(0.1991).margin(5e-5));
  }
}

TEST_CASE("what rides with the sensor hides what stands behind it, all around") {
  World world;
  world.cones.push_back({{0, 0, -40}, {0, 0, 40}, 20.0, 20.0, {-1, Part::kWall}});
  LidarSettings settings = quiet_sensor();
  settings.field_of_view_deg = 360.0;
  const LidarSimulator lidar(world, settings, 1);
  const EvenMotion motion(1.0, 0.3);
  for (double bearing = -3.0; bearing < 3.2; bearing += 0.75) {
    const Eigen::Vector3d foot(4.0 * std::cos(bearing), 4.0 * std::sin(bearing), -5.0);
    const Cone post = {foot, foot + Eigen::Vector3d(0, 0, 10), 0.2, 0.2, {-1, Part::kMachine}};
    const TruthfulSweep result = lidar.cast(motion, 2, std::span(&post, 1));
    for (std::size_t i = 0; i < result.truth.size(); ++i) {
      const Eigen::Vector3d d =
          lidar.model().direction(result.sweep.returns[i].laser,
                                  result.sweep.azimuth_rad(result.sweep.returns[i], lidar.model()));
      const double along = d.head<2>().normalized().dot(foot.head<2>());
      const double off = std::sqrt(std::max(0.0, 16.0 - along * along));
      if (std::fabs(off - 0.2) < 1e-5) continue;
      const bool hidden = along > 0.0 && off < 0.2;
      REQUIRE((result.truth[i].label.part == Part::kMachine) == hidden);
      if (hidden) CHECK(result.truth[i].range_m * d.head<2>().norm() < 4.0);
    }
  }
}

}  // namespace honka::sim
