// Is what a track states of its error true? Worlds whose errors have known sizes, many times.
#include <Eigen/Eigenvalues>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "algo/localize/tracking/tracker.h"
#include "algo/odometry/odometry.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

constexpr double kStep_m = 0.1;  // a scan, 0.1 s

Eigen::Matrix3d diagonal(double metres, double radians) {
  return Eigen::Vector3d(metres * metres, metres * metres, radians * radians).asDiagonal();
}

/// What is wrong with a drive, and what the tracker is told of it.
struct ErrorWorld {
  double drift = 0.0;               ///< s.d., metres a metre
  double registration_m = 0.01;     ///< stated of each scan; renewed over shared_length_m
  double registration_rad = 0.002;  ///< the same of yaw
  double fix_m = 0.05, fix_rad = 0.01;
  double shared_share = 0.0;     ///< of the fixes' variance
  double shared_length_m = 5.0;  ///< over which that part is forgotten
  double fix_every_m = 0.5;
  double stated_scale = 1.0;  ///< stated over true s.d. of fixes
};

Eigen::Vector3d normal3(RandomStream& random) {
  const double x = random.normal(), y = random.normal();
  return {x, y, random.normal()};
}

/// Normalized error squared at the end of 60 m.
double nees_after_drive(const ErrorWorld& world, const TrackingSettings& settings,
                        std::uint64_t seed) {
  RandomStream random(seed, "track_consistency");
  const Eigen::Matrix3d registration = diagonal(world.registration_m, world.registration_rad);
  const Eigen::Matrix3d fix_root = diagonal(world.fix_m, world.fix_rad).cwiseSqrt();
  const Eigen::Vector2d drift =
      Eigen::Vector2d(random.normal(), random.normal()) * world.drift;  // of the map's axes
  const Pose2 step{{kStep_m, 0.0}, 0.002};
  const double share = kStep_m / settings.shared_length_m + std::abs(step.yaw_rad);
  PoseTracker tracker(settings);
  Pose2 T_map_lidar, T_odom_lidar;
  Eigen::Vector3d shared = normal3(random);
  const int every = static_cast<int>(std::lround(world.fix_every_m / kStep_m));
  for (int scan = 0; scan < 600; ++scan) {
    if (scan > 0) {
      // The true step is the odometry's with its errors.
      const Eigen::Vector3d walk = std::sqrt(share) * (registration.cwiseSqrt() * normal3(random));
      T_odom_lidar = T_odom_lidar * step;
      T_map_lidar = T_map_lidar * step * Pose2{walk.head<2>(), walk.z()};
      T_map_lidar.translation_m += kStep_m * drift;
      const double kept = std::exp(-kStep_m / world.shared_length_m);
      shared = kept * shared + std::sqrt(1.0 - kept * kept) * normal3(random);
    }
    (void)tracker.add_odometry(0.1 * scan, T_odom_lidar, registration);
    if (scan % every != 0) continue;
    const Eigen::Vector3d error =
        fix_root * (std::sqrt(world.shared_share) * shared +
                    std::sqrt(1.0 - world.shared_share) * normal3(random));
    Pose2 answer = T_map_lidar;
    answer.translation_m += error.head<2>();
    answer.yaw_rad = wrap_to_pi(answer.yaw_rad + error.z());
    const double scale = world.stated_scale;
    tracker.add_fix(
        {0.1 * scan, T_odom_lidar, answer, scale * scale * diagonal(world.fix_m, world.fix_rad)});
  }
  REQUIRE(tracker.pose().has_pose());
  return mahalanobis_squared(tracker.pose().belief, {T_map_lidar, Eigen::Matrix3d::Zero()});
}

double mean_nees(const ErrorWorld& world, const TrackingSettings& settings, int runs) {
  double sum = 0.0;
  for (int run = 0; run < runs; ++run) {
    sum += nees_after_drive(world, settings, static_cast<std::uint64_t>(run));
  }
  return sum / runs;
}

/// Fixes count in full, and hold all of their error.
TrackingSettings fixes_in_full() {
  TrackingSettings settings;
  settings.shared_length_m = 0.5;  // the way between them
  settings.map_sigma_m = 0.0;
  settings.gate_probability = 0.999999;
  return settings;
}

void check_covariance(const Eigen::Matrix3d& covariance) {
  REQUIRE(covariance.allFinite());
  CHECK(covariance == covariance.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance);
  CHECK(axes.eigenvalues().minCoeff() >= -1e-12 * axes.eigenvalues().maxCoeff());
}

}  // namespace

TEST_CASE("With drift, registration errors and fixes as stated the mean NEES is 3") {
  ErrorWorld world;
  world.drift = 0.005;
  TrackingSettings settings = fixes_in_full();
  settings.odometry.drift = world.drift;
  settings.odometry.drift_length_m = 1e5;
  // The registration's own error at a fix is counted with the fix; here it is none.
  world.registration_m = 0.002;
  world.registration_rad = 0.0004;
  constexpr int kRuns = 400;
  const double mean = mean_nees(world, settings, kRuns);
  // 99 % of the means of 400 chi-squares of 3 degrees of freedom: 3 ± 2.58 √(6 / 400)
  CHECK(mean > 3.0 - 0.32);
  CHECK(mean < 3.0 + 0.32);
}

TEST_CASE("A drift that the filter does not know of makes it say too much") {
  ErrorWorld world;
  world.drift = 0.02;
  TrackingSettings settings = fixes_in_full();
  settings.odometry.drift = 0.0;
  world.registration_m = 0.002;
  world.registration_rad = 0.0004;
  CHECK(mean_nees(world, settings, 100) > 6.0);
}

TEST_CASE("Fixes that share their errors do not make the track say too much") {
  ErrorWorld world;
  world.registration_m = 0.002;
  world.registration_rad = 0.0004;
  TrackingSettings settings;
  settings.map_sigma_m = 0.0;
  settings.odometry.drift = 0.0;
  for (const double share : {0.0, 0.5, 1.0}) {
    CAPTURE(share);
    world.shared_share = share;
    const double mean = mean_nees(world, settings, 200);
    CHECK(mean < 4.0);
    CHECK(mean > 0.2);
  }
  // Taken for independent, the same fixes do.
  CHECK(mean_nees(world, fixes_in_full(), 200) > 6.0);
}

TEST_CASE("A stated registration enters once a shared length, once a radian, and not at rest") {
  const TrackingSettings settings;
  const Eigen::Matrix3d stated = diagonal(0.004, 0.0002);
  const auto grown = [&](const Pose2& step) {
    return odometry_step(step, 0.1, stated, settings).covariance;
  };
  CHECK(grown({}).norm() == 0.0);
  CHECK(grown({{settings.shared_length_m, 0.0}, 0.0}).isApprox(stated));
  CHECK(grown({{0.0, 0.0}, -1.0}).isApprox(stated));
  CHECK(grown({{1e-9, 0.0}, 0.0}).norm() < 1e-9 * stated.norm());
  CHECK(grown({{1e4, 0.0}, 0.0}).isApprox(1e4 / settings.shared_length_m * stated));
}

TEST_CASE("A motion that no registration saw costs what a machine can have done") {
  const TrackingSettings settings;
  const Eigen::Matrix3d stated = Eigen::Matrix3d::Identity() * kUnobservedVariance;
  const OdometryStep step = odometry_step({{0.1, 0.0}, 0.0}, 0.2, stated, settings);
  CHECK(std::sqrt(step.covariance(0, 0)) == Approx(0.2 * settings.odometry.unobserved_m_per_s));
  CHECK(std::sqrt(step.covariance(2, 2)) ==
        Approx(0.2 * deg_to_rad(settings.odometry.unobserved_deg_per_s)));
}

TEST_CASE("Drift grows with the way, and is learnt from fixes") {
  OdometryNoiseSettings noise;
  noise.drift = 0.01;
  noise.drift_length_m = 1e6;
  DriftFilter filter({Pose2{}, diagonal(1e-6, 1e-9)}, noise);
  const OdometryStep step{{{10.0, 0.0}, 0.0}, Eigen::Matrix3d::Zero()};
  for (int k = 1; k <= 4; ++k) {
    filter.move(step);
    CHECK(std::sqrt(filter.belief().covariance(1, 1)) == Approx(0.1 * k).epsilon(1e-3));
  }
  // A fix 0.4 m to the left after 40 m: it drifts 1 % to the left from here on, too.
  filter.update({{{40.0, 0.4}, 0.0}, diagonal(1e-6, 1e-9)});
  filter.move(step);
  CHECK(filter.belief().T_map_lidar.translation_m.y() == Approx(0.5).epsilon(1e-3));
  CHECK(std::sqrt(filter.belief().covariance(1, 1)) < 1e-3);
}

TEST_CASE("Along a turn the covariance of the odometry turns with the lidar") {
  Eigen::Matrix3d ahead = Eigen::Matrix3d::Zero();
  ahead(0, 0) = 1.0;
  const Eigen::Matrix3d in_map = covariance_in_map({{}, ahead}, {{5.0, 5.0}, kPi / 2.0});
  CHECK(in_map(0, 0) == Approx(0.0).margin(1e-15));
  CHECK(in_map(1, 1) == Approx(1.0));
}

TEST_CASE("The covariance of a track stays symmetric and positive, and repeats to the digit") {
  const auto run = [](std::uint64_t seed) {
    RandomStream random(seed, "any_motion");
    PoseTracker tracker{TrackingSettings{}};
    constexpr std::array kWays = {0.0, 1e-9, 0.1, 50.0, 1e4};
    constexpr std::array kSigmas = {0.0, 1e-9, 1e-3, 0.3, 32.0};
    Pose2 T_odom_lidar;
    for (int scan = 0; scan < 200; ++scan) {
      const double way_m = kWays[static_cast<std::size_t>(random.uniform(0.0, 4.999))];
      const double sigma = kSigmas[static_cast<std::size_t>(random.uniform(0.0, 4.999))];
      T_odom_lidar = T_odom_lidar * Pose2{{way_m, -0.3 * way_m}, random.normal(0.0, 1.0)};
      (void)tracker.add_odometry(0.1 * scan, T_odom_lidar, diagonal(sigma, 0.1 * sigma));
      tracker.add_fix({0.1 * scan, T_odom_lidar, T_odom_lidar, diagonal(0.01 + sigma, 0.01)});
      if (tracker.pose().has_pose()) check_covariance(tracker.pose().belief.covariance);
    }
    return tracker.pose().belief;
  };
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Belief first = run(seed), again = run(seed);
    CHECK(first.covariance == again.covariance);
    CHECK(first.T_map_lidar.translation_m == again.T_map_lidar.translation_m);
  }
}

TEST_CASE("The tracker takes no covariance of the odometry that is none") {
  PoseTracker tracker{TrackingSettings{}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix3d lopsided = Eigen::Matrix3d::Identity();
  lopsided(0, 1) = 0.5;
  const Eigen::Matrix3d negative = -Eigen::Matrix3d::Identity();
  CHECK_THROWS_AS(tracker.add_odometry(0.0, {}, Eigen::Matrix3d::Constant(nan)), UserError);
  CHECK_THROWS_AS(tracker.add_odometry(0.0, {}, lopsided), UserError);
  CHECK_THROWS_AS(tracker.add_odometry(0.0, {}, negative), UserError);
  CHECK_NOTHROW(tracker.add_odometry(0.0, {}, Eigen::Matrix3d::Zero()));
  CHECK_NOTHROW(tracker.add_odometry(0.1, {}));
  TrackingSettings settings;
  settings.shared_length_m = 0.0;
  CHECK_THROWS_AS(PoseTracker(settings), UserError);
}
