#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <thread>

#include "algo/types/user_error.h"
#include "sim/lidar/lidar_simulator.h"
#include "sim/lidar/shot_noise.h"
#include "tests/sim/lidar/quiet_sensor.h"

namespace honka::sim {
namespace {

World ring(double radius_m) {
  World world;
  world.cones.push_back({{0, 0, -40}, {0, 0, 40}, radius_m, radius_m, {-1, Part::kWall}});
  return world;
}

const StaticTrajectory kStill(Pose3::Identity(), 100.0);

}  // namespace

TEST_CASE("the inverse normal has the quantiles of the tables") {
  const auto bits = [](double p) { return static_cast<std::uint32_t>(p * 4294967296.0); };
  CHECK(normal_of(bits(0.5)) == Approx(0.0).margin(1e-6));
  CHECK(normal_of(bits(0.975)) == Approx(1.959964).margin(1e-5));
  CHECK(normal_of(bits(0.001)) == Approx(-3.090232).margin(1e-5));
  CHECK(normal_of(0xFFFFFFFFU) == Approx(6.3379).margin(2e-3));
  CHECK(normal_of(0) == Approx(-normal_of(0xFFFFFFFFU)).margin(1e-5));
}

TEST_CASE("noise has the asked sigma about the laser's own bias") {
  LidarSettings settings = quiet_sensor();
  settings.range_noise_m = 0.012;
  settings.range_bias_m = 0.03;
  const LidarSimulator lidar(ring(20.0), settings, 11);
  std::vector<double> sum(16), squares(16), count(16);
  for (int sweep = 0; sweep < 6; ++sweep) {
    const TruthfulSweep result = lidar.cast(kStill, sweep);
    for (std::size_t i = 0; i < result.truth.size(); ++i) {
      const Return& r = result.sweep.returns[i];
      const double error = 0.002 * r.range_ticks - result.truth[i].range_m;
      sum[r.laser] += error;
      squares[r.laser] += error * error;
      count[r.laser] += 1;
    }
  }
  double widest = 0.0;
  for (std::size_t laser = 0; laser < 16; ++laser) {
    const double mean = sum[laser] / count[laser];
    const double sigma = std::sqrt(squares[laser] / count[laser] - mean * mean);
    CHECK(mean == Approx(lidar.biases_m()[laser]).margin(6e-4));
    CHECK(std::fabs(lidar.biases_m()[laser]) <= 0.03);
    // The 2 mm steps add their own variance, step² / 12.
    CHECK(sigma == Approx(std::sqrt(0.012 * 0.012 + 4e-6 / 12)).epsilon(0.04));
    widest = std::max(widest, std::fabs(lidar.biases_m()[laser]));
  }
  CHECK(widest > 0.01);
}

TEST_CASE("shots get lost at the asked rate, and weak ones as the range says") {
  const auto share = [](const LidarSettings& settings, double radius_m) {
    const LidarSimulator lidar(ring(radius_m), settings, 4);
    double lost = 0.0, all = 0.0;
    for (int sweep = 0; sweep < 4; ++sweep) {
      for (const Return& r : lidar.cast(kStill, sweep).sweep.returns) {
        lost += r.range_ticks == 0 ? 1.0 : 0.0;
        all += 1.0;
      }
    }
    return lost / all;
  };
  LidarSettings settings = quiet_sensor();
  CHECK(share(settings, 20.0) == 0.0);
  settings.drop_out = 0.05;
  CHECK(share(settings, 20.0) == Approx(0.05).margin(0.004));
  settings.drop_out = 0.0;
  settings.half_detection_range_m = 60.0;
  CHECK(share(settings, 20.0) == 0.0);
  // A 50 % wall at 60 m √5 is as bright as a 10 % one at 60 m: with the slant a good half is lost.
  settings.max_range_m = 131.0;
  const double lost = share(settings, 60.0 * std::sqrt(5.0) * 0.95);
  CHECK(lost > 0.3);
  CHECK(lost < 0.6);
}

TEST_CASE("digits depend on seed, sweep, firing and laser, not on order or threads") {
  LidarSettings settings;
  settings.sub_rays = 5;
  settings.return_mode = "dual";
  World world = ring(20.0);
  world.cones.push_back({{5, 1, -3}, {5, 1, 9}, 0.2, 0.1, {3, Part::kStem}});
  const LidarSimulator lidar(world, settings, 21), again(world, settings, 21),
      other(world, settings, 22);
  std::vector<std::vector<Return>> forward(8), threaded(8);
  for (int i = 0; i < 8; ++i)
    forward[static_cast<std::size_t>(i)] = lidar.cast(kStill, i).sweep.returns;
  std::vector<std::thread> threads;
  for (int part = 0; part < 2; ++part) {
    threads.emplace_back([&, part] {
      for (int i = 7 - part; i >= 0; i -= 2) {
        threaded[static_cast<std::size_t>(i)] = again.cast(kStill, i).sweep.returns;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(forward == threaded);
  CHECK(forward[0] != forward[1]);
  CHECK(other.cast(kStill, 0).sweep.returns != forward[0]);
}

TEST_CASE("surfaces nearer than the least range and beyond the largest give nothing") {
  LidarSettings settings = quiet_sensor();
  settings.min_range_m = 3.0;
  settings.max_range_m = 30.0;
  for (const double radius_m : {2.0, 10.0, 35.0}) {
    const LidarSimulator lidar(ring(radius_m), settings, 1);
    for (const Return& r : lidar.cast(kStill, 0).sweep.returns) {
      CHECK((r.range_ticks > 0) == (radius_m == 10.0));
    }
  }
}

TEST_CASE("a sensor or mode that nobody knows is the user's mistake") {
  LidarSettings settings;
  settings.model = "vlp17";
  CHECK_THROWS_AS(LidarSimulator(World(), settings, 1), UserError);
  settings.model = "hdl32";
  CHECK(LidarSimulator(World(), settings, 1).model().lasers.size() == 32);
}

}  // namespace honka::sim
