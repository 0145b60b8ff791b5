// The sensor's laser table and the points it reports.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/lidar_model.h"
#include "algo/types/sweep.h"

using namespace honka;

TEST_CASE("VLP-16: lasers in firing order (manual 63-9243, table 9-1)") {
  const LidarModel model = vlp16();
  REQUIRE(model.lasers.size() == 16);
  // Even ids climb from −15° to −1°, odd ids from +1° to +15°, in steps of 2°.
  for (std::size_t id = 0; id < 16; ++id) {
    const double expected_deg =
        id % 2 == 0 ? -15.0 + static_cast<double>(id) : static_cast<double>(id);
    CHECK(rad_to_deg(model.lasers[id].elevation_rad) == Approx(expected_deg));
    CHECK(model.lasers[id].firing_offset_s == Approx(2.304e-6 * static_cast<double>(id)));
    CHECK(model.lasers[id].vertical_offset_m == 0.0);
  }
  CHECK(model.firing_period_s == Approx(55.296e-6));
  CHECK(model.range_resolution_m == 0.002);
  CHECK(model.sweep_period_s() == Approx(0.1));
  CHECK(vlp16(20.0).sweep_period_s() == Approx(0.05));
}

TEST_CASE("VLP-16: vertical offsets of the beams in millimetres (table 9-1)") {
  const LidarModel model = vlp16(10.0, true);
  CHECK(1e3 * model.lasers[0].vertical_offset_m == Approx(11.2).margin(0.06));
  CHECK(1e3 * model.lasers[1].vertical_offset_m == Approx(-0.7).margin(0.06));
  CHECK(1e3 * model.lasers[15].vertical_offset_m == Approx(-11.2).margin(0.06));
  CHECK(model.origin(0).z() == model.lasers[0].vertical_offset_m);
}

TEST_CASE("beams: azimuth 0 is ahead, azimuth grows to the right") {
  const LidarModel model = vlp16();
  for (int laser = 0; laser < 16; ++laser) {
    const Eigen::Vector3d ahead = model.direction(laser, 0.0);
    const Eigen::Vector3d right = model.direction(laser, kPi / 2);
    CHECK(ahead.norm() == Approx(1.0));
    CHECK(ahead.y() == Approx(0.0).margin(1e-12));
    CHECK(ahead.x() > 0.9);
    CHECK(right.y() < -0.9);
    CHECK(std::asin(ahead.z()) ==
          Approx(model.lasers[static_cast<std::size_t>(laser)].elevation_rad));
  }
}

TEST_CASE("a return becomes a point: ticks, azimuth by time, elevation") {
  const LidarModel model = vlp16();
  Sweep sweep;
  sweep.start_time_s = 12.0;
  sweep.start_azimuth_rad = 0.0;
  Return echo;
  echo.laser = 1;                    // +1°
  echo.range_ticks = 5000;           // 10 m
  echo.time_offset_ns = 25'000'000;  // a quarter of a revolution at 10 Hz: to the right
  CHECK(sweep.time_s(echo) == Approx(12.025));
  CHECK(sweep.azimuth_rad(echo, model) == Approx(kPi / 2));
  const Eigen::Vector3d p = sweep.point_in_lidar(echo, model);
  CHECK(p.norm() == Approx(10.0));
  CHECK(p.y() == Approx(-10.0 * std::cos(deg_to_rad(1.0))));
  CHECK(p.z() == Approx(10.0 * std::sin(deg_to_rad(1.0))));
  CHECK(p.x() == Approx(0.0).margin(1e-9));

  sweep.start_azimuth_rad = kPi / 2;  // begun a quarter turn later: behind
  CHECK(sweep.point_in_lidar(echo, model).x() < -9.9);
}

TEST_CASE("the vertical offset moves the origin of the beam") {
  const LidarModel model = vlp16(10.0, true);
  Return echo;
  echo.range_ticks = 1000;
  const Sweep sweep;
  const Eigen::Vector3d p = sweep.point_in_lidar(echo, model);
  CHECK((p - model.origin(0)).norm() == Approx(2.0));
  CHECK((p - model.origin(0)).normalized().dot(model.direction(0, 0.0)) == Approx(1.0));
}
