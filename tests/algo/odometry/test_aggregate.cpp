#include <catch2/catch.hpp>
#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/odometry/aggregate.h"

using namespace honka;

namespace {

/// The range of a vertical wall at x = `wall_m` (world) from a moving sensor, with whole ticks of
/// a micrometre so that rounding does not hide an error.
struct WallDrive {
  Pose3 T_world_start, T_world_end;
  double wall_m = 10.0;
  LidarModel model = vlp16();

  WallDrive(const Pose3& start, const Pose3& end) : T_world_start(start), T_world_end(end) {
    model.range_resolution_m = 0.0005;
  }
  [[nodiscard]] Sweep sweep() const {
    Sweep sweep;
    sweep.start_azimuth_rad = deg_to_rad(-40.0);
    for (std::uint32_t firing = 0; firing < 400; ++firing) {
      for (std::uint8_t laser = 0; laser < 16; ++laser) {
        Return r;
        const double offset_s =
            firing * model.firing_period_s + model.lasers[laser].firing_offset_s;
        r.time_offset_ns = static_cast<std::uint32_t>(std::lround(offset_s * 1e9));
        r.laser = laser;
        r.range_ticks = static_cast<std::uint16_t>(std::lround(range(sweep, r) / 0.0005));
        sweep.returns.push_back(r);
      }
    }
    return sweep;
  }
  [[nodiscard]] double range(const Sweep& sweep, const Return& r) const {
    const double share = 1e-9 * r.time_offset_ns / model.sweep_period_s();
    const Pose3 pose = interpolate(T_world_start, T_world_end, share);
    const Eigen::Vector3d ray =
        pose.linear() * model.direction(r.laser, sweep.azimuth_rad(r, model));
    return (wall_m - pose.translation().x()) / ray.x();
  }
};

double worst_wall_error(const WallDrive& drive, const PosedSweep& posed) {
  double worst_m = 0.0;
  std::size_t count = 0;
  for_each_point(posed, drive.model, {}, [&](const Eigen::Vector3d& p) {
    worst_m = std::max(worst_m, std::abs(p.x() - drive.wall_m));
    ++count;
  });
  REQUIRE(count > 5000);
  return worst_m;
}

}  // namespace

TEST_CASE("a wall stays flat from a driving, turning, rolling sensor") {
  const WallDrive drive(pose_from_rpy({0.0, 0.0, 2.0}, 0.02, -0.03, 0.1),
                        pose_from_rpy({0.2, 0.05, 2.01}, 0.01, -0.02, 0.25));
  const Sweep sweep = drive.sweep();
  CHECK(worst_wall_error(drive, {&sweep, drive.T_world_start, drive.T_world_end}) < 0.0006);
  CHECK(worst_wall_error(drive, {&sweep, drive.T_world_start, drive.T_world_start}) > 0.05);
}

TEST_CASE("a still sensor gives Sweep::point_in_lidar") {
  const WallDrive drive(Pose3::Identity(), Pose3::Identity());
  const Sweep sweep = drive.sweep();
  const PosedSweep posed{&sweep, Pose3::Identity(), Pose3::Identity()};
  KeyFrameSettings all;
  all.max_range_m = 1000.0;
  const LocalCloud cloud = aggregate({&posed, 1}, drive.model, all, Pose3::Identity());
  REQUIRE(cloud.size() == sweep.returns.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d expected = sweep.point_in_lidar(sweep.returns[i], drive.model);
    CHECK((cloud.points_m[i] - expected).norm() < 1e-12);
  }
}

TEST_CASE("the local frame is levelled, at the sensor, along its heading") {
  const Pose3 T_odom_lidar = pose_from_rpy({10.0, -4.0, 2.5}, 0.1, -0.2, 1.3);
  const Pose3 T_odom_local = levelled(T_odom_lidar);
  CHECK((T_odom_local.translation() - T_odom_lidar.translation()).norm() == 0.0);
  CHECK(T_odom_local.linear()(2, 2) == Approx(1.0).margin(1e-15));
  CHECK(yaw_of(T_odom_local) == Approx(yaw_of(T_odom_lidar)));
}

TEST_CASE("sweeps meet in the frame of the reference, with their origins") {
  const Pose3 first = pose_from_rpy({0.0, 0.0, 2.0}, 0.05, 0.0, 0.0);
  const Pose3 last = pose_from_rpy({1.0, 0.5, 2.2}, 0.0, 0.1, 0.4);
  const WallDrive a(first, first), b(last, last);
  const Sweep sweep_a = a.sweep(), sweep_b = b.sweep();
  const std::vector<PosedSweep> posed = {{&sweep_a, first, first}, {&sweep_b, last, last}};
  const LocalCloud cloud = aggregate(posed, a.model, {}, last);
  REQUIRE(cloud.origins_m.size() == 2);
  CHECK(cloud.origins_m[1].norm() < 1e-12);
  const Pose3 T_world_local = levelled(last);
  CHECK((T_world_local * cloud.origins_m[0] - first.translation()).norm() < 1e-12);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    CHECK(std::abs((T_world_local * cloud.points_m[i]).x() - 10.0) < 0.0006);
  }
  CHECK(cloud.frames.front() == 0);
  CHECK(cloud.frames.back() == 1);
}

TEST_CASE("misses and ranges outside the limits are no points") {
  const LidarModel model = vlp16();
  Sweep sweep;
  for (const int ticks : {0, 100, 2500, 19999, 20001}) {
    Return r;
    r.range_ticks = static_cast<std::uint16_t>(ticks);
    sweep.returns.push_back(r);
  }
  const PosedSweep posed{&sweep, Pose3::Identity(), Pose3::Identity()};
  const LocalCloud cloud = aggregate({&posed, 1}, model, {}, Pose3::Identity());
  CHECK(cloud.size() == 2);  // 5 m and 39.998 m; 0.2 m and 40.002 m are outside
  CHECK(aggregate({}, model, {}, Pose3::Identity()).size() == 0);
}

TEST_CASE("the map of a run grows with the surface, not with the sweeps") {
  const WallDrive drive(Pose3::Identity(), Pose3::Identity());
  const Sweep sweep = drive.sweep();
  const PosedSweep posed{&sweep, Pose3::Identity(), Pose3::Identity()};
  const LocalCloud points_in_map = aggregate({&posed, 1}, drive.model, {}, Pose3::Identity());
  CloudMap map(0.025);
  map.add(points_in_map);
  const std::size_t once = map.size();
  for (int k = 0; k < 5; ++k) map.add(points_in_map);
  CHECK(map.size() == once);
  const LocalCloud cloud = map.cloud();
  CHECK(cloud.frames.size() == cloud.size());
  CHECK(cloud.origins_m.size() == 6);
}
