// A track from odometry and localizations, in worlds whose answers are known on paper.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "algo/localize/tracking/tracker.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"

using namespace honka;

namespace {

/// A sensor that drives 0.1 m a scan along a wide curve, 10 scans a second.
Pose2 curve_pose(int scan) {
  constexpr double kRadius_m = 60.0;
  const double angle = 0.1 * scan / kRadius_m;
  return {{kRadius_m * std::sin(angle), kRadius_m * (1.0 - std::cos(angle))}, wrap_to_pi(angle)};
}

double scan_time_s(int scan) { return 0.1 * scan; }

TrackFix fix_at(int scan, const Pose2& T_odom_lidar, const Pose2& T_map_local) {
  return {scan_time_s(scan), T_odom_lidar, T_map_local, std::nullopt};
}

/// Nothing shared, nothing hidden, no drift: fixes as independent as the filter takes them.
TrackingSettings independent_fixes() {
  TrackingSettings settings;
  settings.shared_length_m = 1e-3;
  settings.odometry.drift = 0.0;
  settings.map_sigma_m = 0.0;
  settings.map_sigma_deg = 0.0;
  return settings;
}

double distance_m(const Pose2& a, const Pose2& b) {
  return (a.translation_m - b.translation_m).norm();
}

std::vector<TrackEvent::Kind> kinds_of(const PoseTracker& tracker) {
  std::vector<TrackEvent::Kind> kinds;
  for (const TrackEvent& event : tracker.events()) kinds.push_back(event.kind);
  return kinds;
}

/// Exact odometry in a frame of its own, exact fixes every 10 scans from `first` to before `end`.
struct ExactDrive {
  explicit ExactDrive(const TrackingSettings& settings = {}) : tracker(settings) {}

  void drive(int first, int end, bool with_fixes, const Pose2& T_map_world = {}) {
    for (int scan = first; scan < end; ++scan) {
      const Pose2 T_odom_lidar = T_odom_world * curve_pose(scan);
      last = tracker.add_odometry(scan_time_s(scan), T_odom_lidar);
      if (!with_fixes || scan % 10 != 0) continue;
      tracker.add_fix(fix_at(scan, T_odom_lidar, T_map_world * curve_pose(scan)));
      last = tracker.pose();
    }
  }

  Pose2 T_odom_world{{-7.0, 3.0}, 2.0};
  PoseTracker tracker;
  TrackedPose last;
};

}  // namespace

TEST_CASE("A track without fixes has no pose") {
  ExactDrive world;
  world.drive(0, 100, false);
  CHECK(world.last.state == TrackState::kSearching);
  CHECK_FALSE(world.last.has_pose());
  CHECK_FALSE(world.tracker.prior());
  CHECK(world.tracker.events().empty());
}

TEST_CASE("Exact fixes and exact odometry give the exact pose at every scan") {
  ExactDrive world;
  world.drive(0, 21, true);
  CHECK(kinds_of(world.tracker) == std::vector{TrackEvent::Kind::kInitialised});
  for (int scan = 21; scan < 200; ++scan) {
    world.drive(scan, scan + 1, true);
    REQUIRE(world.last.state == TrackState::kTracking);
    CHECK(distance_m(world.last.belief.T_map_lidar, curve_pose(scan)) < 1e-9);
    CHECK(std::abs(wrap_to_pi(world.last.belief.T_map_lidar.yaw_rad - curve_pose(scan).yaw_rad)) <
          1e-9);
  }
}

TEST_CASE("Between fixes the track is the odometry, and its covariance grows as the random walk") {
  TrackingSettings settings = independent_fixes();
  settings.odometry = {0.1, 0.0, 0.0, 0.0, 0.0, 0.0};  // 0.1 m per root metre, nothing else
  settings.fix_sigma_deg = 1e-6;
  ExactDrive world(settings);
  world.drive(0, 21, true);
  REQUIRE(world.last.has_pose());
  const double before = world.last.belief.covariance(0, 0);
  world.drive(21, 421, false);  // 40 m
  CHECK(distance_m(world.last.belief.T_map_lidar, curve_pose(420)) < 1e-9);
  CHECK(world.last.belief.covariance(0, 0) - before == Approx(0.01 * 40.0).epsilon(1e-3));
  CHECK(world.last.belief.covariance(1, 1) - before == Approx(0.01 * 40.0).epsilon(1e-3));
  CHECK(largest_position_sigma_m(world.last.belief) ==
        Approx(std::sqrt(world.last.belief.covariance(0, 0))).epsilon(1e-3));
}

TEST_CASE("A yaw error becomes a position error over the way") {
  Belief belief;
  belief.covariance(2, 2) = 0.01 * 0.01;
  const Belief ahead = moved(belief, {{{50.0, 0.0}, 0.0}, Eigen::Matrix3d::Zero()});
  CHECK(ahead.covariance(0, 0) == Approx(0.0).margin(1e-15));
  CHECK(std::sqrt(ahead.covariance(1, 1)) == Approx(0.5));
}

TEST_CASE("chi-square quantiles are those of the tables") {
  CHECK(chi_square_3_quantile(0.95) == Approx(7.815).epsilon(1e-4));
  CHECK(chi_square_3_quantile(0.999) == Approx(16.266).epsilon(1e-4));
}

TEST_CASE("A fix and a track are weighed by their covariances") {
  Belief a, b;
  a.covariance = Eigen::Matrix3d::Identity() * 3.0;
  b.covariance = Eigen::Matrix3d::Identity();
  b.T_map_lidar = {{4.0, 0.0}, 0.0};
  const auto fused = [](const Belief& track, const Belief& fix) {
    DriftFilter filter(track, {});
    filter.update(fix);
    return filter.belief();
  };
  const Belief both = fused(a, b);
  CHECK(both.T_map_lidar.translation_m.x() == Approx(3.0));
  CHECK(both.covariance(0, 0) == Approx(0.75));
  // across ±180° too
  a.T_map_lidar.yaw_rad = kPi - 0.1;
  b.T_map_lidar.yaw_rad = -kPi + 0.1;
  CHECK(fused(a, b).T_map_lidar.yaw_rad == Approx(-kPi + 0.05));
}

namespace {

/// Normalized error squared of a track at the end of a noisy drive whose noise is that of the
/// settings, fixes every 5 scans.
double final_nees(const TrackingSettings& settings, std::uint64_t seed) {
  RandomStream random(seed, "tracking_test");
  PoseTracker tracker(settings);
  const double yaw_sd = deg_to_rad(settings.odometry.sigma_deg_per_sqrt_m);
  const double fix_yaw_sd = deg_to_rad(settings.fix_sigma_deg);
  Pose2 T_odom_lidar;
  for (int scan = 0; scan < 300; ++scan) {
    if (scan > 0) {
      Pose2 step = curve_pose(scan - 1).inverse() * curve_pose(scan);
      const double root_m = std::sqrt(step.translation_m.norm());
      const double sd = settings.odometry.sigma_m_per_sqrt_m * root_m;
      step.translation_m += Eigen::Vector2d(random.normal(0.0, sd), random.normal(0.0, sd));
      step.yaw_rad += random.normal(0.0, yaw_sd * root_m);
      T_odom_lidar = T_odom_lidar * step;
    }
    (void)tracker.add_odometry(scan_time_s(scan), T_odom_lidar);
    if (scan % 5 != 0) continue;
    Pose2 answer = curve_pose(scan);
    answer.translation_m.x() += random.normal(0.0, settings.fix_sigma_m);
    answer.translation_m.y() += random.normal(0.0, settings.fix_sigma_m);
    answer.yaw_rad = wrap_to_pi(answer.yaw_rad + random.normal(0.0, fix_yaw_sd));
    tracker.add_fix(fix_at(scan, T_odom_lidar, answer));
  }
  const TrackedPose last = tracker.pose();
  REQUIRE(last.has_pose());
  const Belief truth{curve_pose(299), Eigen::Matrix3d::Zero()};
  return mahalanobis_squared(last.belief, truth);
}

}  // namespace

TEST_CASE("The normalized error squared of a track has the mean 3 that it must have") {
  TrackingSettings settings = independent_fixes();
  settings.odometry.sigma_deg_per_sqrt_turn = 0.0;
  settings.odometry.sigma_m_per_sqrt_s = 0.0;
  settings.odometry.sigma_deg_per_sqrt_s = 0.0;
  settings.confirm_distance_m = 0.0;
  constexpr int kSeeds = 400;
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) sum += final_nees(settings, seed);
  // 95 % band of the mean of 400 chi-squares of 3 degrees of freedom: 3 ± 1.96 √(6 / 400)
  CHECK(sum / kSeeds > 2.76);
  CHECK(sum / kSeeds < 3.24);
}

TEST_CASE("One wrong fix does not move a track") {
  ExactDrive world;
  world.drive(0, 100, true);
  const Pose2 before = world.last.belief.T_map_lidar;
  const TrackFix wrong = fix_at(99, world.T_odom_world * curve_pose(99), Pose2{{80.0, -20.0}, 1.0});
  CHECK(world.tracker.add_fix(wrong) == FixUse::kRejected);
  CHECK(distance_m(world.tracker.pose().belief.T_map_lidar, before) == 0.0);
  world.drive(100, 200, true);
  CHECK(kinds_of(world.tracker) == std::vector{TrackEvent::Kind::kInitialised});
}

TEST_CASE("A kidnapping is seen at the third fix that agrees, and the track goes on there") {
  ExactDrive world;
  world.drive(0, 100, true);
  const Pose2 T_map_world{{300.0, 40.0}, -1.0};  // the machine is carried away at scan 100
  world.drive(100, 119, true, T_map_world);
  CHECK(world.last.state == TrackState::kTracking);
  world.drive(119, 125, true, T_map_world);  // fixes were at 100, 110, 120
  using Kind = TrackEvent::Kind;
  CHECK(kinds_of(world.tracker) ==
        std::vector{Kind::kInitialised, Kind::kKidnapped, Kind::kRecovered});
  CHECK(world.tracker.events()[1].time_s == Approx(scan_time_s(120)));
  CHECK(world.tracker.events()[1].distance_m > 200.0);
  CHECK(distance_m(world.last.belief.T_map_lidar, T_map_world * curve_pose(124)) < 1e-9);
}

TEST_CASE("Fixes that agree with nothing lose the track, later ones that agree recover it") {
  TrackingSettings settings;
  ExactDrive world(settings);
  world.drive(0, 100, true);
  for (int k = 0; k < settings.lost_after; ++k) {
    const Pose2 wrong{{500.0 + 100.0 * k, 0.0}, 0.3 * k};
    (void)world.tracker.add_fix(fix_at(99, world.T_odom_world * curve_pose(99), wrong));
  }
  CHECK(world.tracker.pose().state == TrackState::kLost);
  CHECK_FALSE(world.tracker.prior());
  world.drive(100, 200, true);
  using Kind = TrackEvent::Kind;
  CHECK(kinds_of(world.tracker) == std::vector{Kind::kInitialised, Kind::kLost, Kind::kRecovered});
  CHECK(distance_m(world.last.belief.T_map_lidar, curve_pose(199)) < 1e-9);
}

TEST_CASE("A track without fixes coasts, says so, and its prior widens") {
  ExactDrive world;
  world.drive(0, 100, true);
  const double radius_m = world.tracker.prior()->radius_m;
  world.drive(100, 400, false);
  CHECK(world.last.state == TrackState::kCoasting);
  CHECK(world.last.has_pose());
  CHECK(world.last.since_fix_s == Approx(30.9));
  CHECK(world.tracker.prior()->radius_m > radius_m);
  world.drive(400, 420, true);
  using Kind = TrackEvent::Kind;
  CHECK(kinds_of(world.tracker) ==
        std::vector{Kind::kInitialised, Kind::kCoasting, Kind::kRecovered});
}

TEST_CASE("After refusals in a row the whole map is asked again") {
  TrackingSettings settings;
  ExactDrive world(settings);
  world.drive(0, 100, true);
  for (int k = 0; k < settings.prior_misses; ++k) {
    CHECK(world.tracker.prior());
    world.tracker.add_miss();
  }
  CHECK_FALSE(world.tracker.prior());
  world.drive(100, 111, true);
  CHECK(world.tracker.prior());
}

TEST_CASE("Fixes of the same stems count as one") {
  TrackingSettings settings;
  settings.odometry = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  settings.shared_length_m = 10.0;
  ExactDrive world(settings);
  world.drive(0, 21, true);
  const double first = world.last.belief.covariance(0, 0);
  world.drive(21, 121, true);  // ten more fixes over 10 m: the information of one
  CHECK(world.last.belief.covariance(0, 0) == Approx(first / 2.0).epsilon(0.02));
}

TEST_CASE("A fix of an earlier scan is carried on by the odometry") {
  ExactDrive world;
  world.drive(0, 100, true);
  const TrackFix late = fix_at(60, world.T_odom_world * curve_pose(60), curve_pose(60));
  CHECK(world.tracker.add_fix(late) == FixUse::kUsed);
  CHECK(distance_m(world.tracker.pose().belief.T_map_lidar, curve_pose(99)) < 1e-9);
}

TEST_CASE("Tracking takes no number that is none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ExactDrive world;
  CHECK_THROWS_AS(world.tracker.add_fix({}), UserError);  // before the first scan
  world.drive(0, 100, true);
  const Pose2 T_odom_lidar = world.T_odom_world * curve_pose(99);
  CHECK_THROWS_AS(world.tracker.add_odometry(nan, T_odom_lidar), UserError);
  CHECK_THROWS_AS(world.tracker.add_odometry(1.0, T_odom_lidar), UserError);  // runs backwards
  CHECK_THROWS_AS(world.tracker.add_odometry(20.0, {{nan, 0.0}, 0.0}), UserError);
  CHECK(world.tracker.add_fix(fix_at(99, T_odom_lidar, {{nan, 0.0}, 0.0})) == FixUse::kRefused);
  TrackFix fix = fix_at(99, T_odom_lidar, curve_pose(99));
  fix.covariance = Eigen::Matrix3d::Zero();
  CHECK(world.tracker.add_fix(fix) == FixUse::kRefused);
  fix.covariance = Eigen::Matrix3d::Constant(nan);
  CHECK(world.tracker.add_fix(fix) == FixUse::kRefused);
  CHECK(world.tracker.pose().belief.covariance.allFinite());
  TrackingSettings settings;
  settings.gate_probability = 1.0;
  CHECK_THROWS_AS(PoseTracker(settings), UserError);
}

TEST_CASE("The false-alarm probability of a kidnapping is that of its fixes") {
  TrackingSettings settings;
  CHECK(settings.false_alarm_probability() == Approx(1e-9));
}
