#include "eval/run/truth_noise_odometry.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

using namespace honka;
using honka::eval::OdometrySettings;
using honka::eval::TruthNoiseOdometry;

namespace {

/// Along x at a constant speed, level, with a slow turn.
class Line : public sim::Trajectory {
 public:
  explicit Line(double speed_m_s) : speed_m_s_(speed_m_s) {}
  [[nodiscard]] double duration_s() const override { return 1e4; }
  [[nodiscard]] Pose3 T_world_lidar(double time_s) const override {
    return pose_from_rpy({speed_m_s_ * time_s, 2.0, 1.5}, 0.0, 0.0, 0.01 * time_s);
  }

 private:
  double speed_m_s_;
};

/// x, y, z, roll, pitch, yaw of the error of a sweep's pose.
using Errors = std::array<double, 6>;

Errors errors_at(const TruthNoiseOdometry& odometry, const Line& truth, std::int64_t sweep,
                 double time_s) {
  const Pose3 T_odom_lidar = odometry.T_odom_lidar(sweep, time_s);
  const Pose3 T_world_lidar = truth.T_world_lidar(time_s);
  const Eigen::Vector3d t = T_odom_lidar.translation() - T_world_lidar.translation();
  const Eigen::Matrix3d r = T_odom_lidar.linear() * T_world_lidar.linear().transpose();
  return {t.x(),
          t.y(),
          t.z(),
          std::atan2(r(2, 1), r(2, 2)),
          -std::asin(r(2, 0)),
          std::atan2(r(1, 0), r(0, 0))};
}

constexpr int kSeeds = 2000;

/// Mean product of the errors of two sweeps over many seeds; 1 s and `speed` metres a sweep.
Errors mean_products(const OdometrySettings& settings, double speed_m_s, std::int64_t a,
                     std::int64_t b) {
  const Line truth(speed_m_s);
  Errors sum{};
  for (int seed = 0; seed < kSeeds; ++seed) {
    const TruthNoiseOdometry odometry(truth, 1.0, b + 1, settings,
                                      static_cast<std::uint64_t>(seed));
    const Errors at_a = errors_at(odometry, truth, a, static_cast<double>(a));
    const Errors at_b = errors_at(odometry, truth, b, static_cast<double>(b));
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += at_a[i] * at_b[i] / kSeeds;
  }
  return sum;
}

/// Five standard deviations of a variance estimated from so many normal samples.
const double kShare = 5.0 * std::sqrt(2.0 / kSeeds);

}  // namespace

TEST_CASE("drift and jitter have the asked moments at the start and anywhere on the way") {
  const std::string follows = GENERATE("place", "way");
  const OdometrySettings settings{"truth+noise", follows, 0.2, 0.5, 20.0, 0.05, 0.1};
  const double planar = 0.2 * 0.2 + 0.05 * 0.05, jitter = 0.05 * 0.05;
  const double tilt = std::pow(deg_to_rad(0.1), 2);
  const double yaw = std::pow(deg_to_rad(0.5), 2) + tilt;
  for (const std::int64_t sweep : {0, 7, 60}) {
    CAPTURE(sweep);
    const Errors variance = mean_products(settings, 1.0, sweep, sweep);
    const Errors expected = {planar, planar, jitter, tilt, tilt, yaw};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(i);
      CHECK(std::abs(variance[i] / expected[i] - 1.0) < kShare);
    }
  }
}

TEST_CASE("drift forgets itself over the way driven, not over time") {
  const std::string follows = GENERATE("place", "way");
  const OdometrySettings settings{"truth+noise", follows, 0.2, 0.5, 20.0, 0.0, 0.0};
  const double planar = 0.2 * 0.2, yaw = std::pow(deg_to_rad(0.5), 2);
  const auto check = [&](double speed_m_s, double correlation) {
    const Errors product = mean_products(settings, speed_m_s, 3, 13);
    CHECK(std::abs(product[0] / planar - correlation) < kShare);
    CHECK(std::abs(product[1] / planar - correlation) < kShare);
    CHECK(std::abs(product[5] / yaw - correlation) < kShare);
  };
  check(1.0, std::exp(-10.0 / 20.0));
  check(4.0, std::exp(-40.0 / 20.0));
  check(0.0, 1.0);
}

TEST_CASE("a drift that follows the place comes back with it, one that follows the way does not") {
  /// Out along x for 50 s, and back.
  class OutAndBack : public sim::Trajectory {
   public:
    [[nodiscard]] double duration_s() const override { return 100.0; }
    [[nodiscard]] Pose3 T_world_lidar(double time_s) const override {
      return pose_from_rpy({50.0 - std::abs(time_s - 50.0), 0.0, 1.5}, 0.0, 0.0, 0.0);
    }
  };
  const OutAndBack truth;
  const auto gap_m = [&](const std::string& follows) {
    const OdometrySettings settings{"truth+noise", follows, 0.2, 0.5, 20.0, 0.0, 0.0};
    const TruthNoiseOdometry odometry(truth, 1.0, 100, settings, 3);
    return (odometry.T_odom_lidar(10, 10.0).translation() -
            odometry.T_odom_lidar(90, 90.0).translation())
        .norm();
  };
  CHECK(gap_m("place") < 1e-12);
  CHECK(gap_m("way") > 0.01);
}

TEST_CASE("jitter is independent from sweep to sweep, also at rest") {
  const OdometrySettings settings{"truth+noise", "way", 0.0, 0.0, 20.0, 0.05, 0.1};
  for (const double speed_m_s : {0.0, 1.0}) {
    const Errors product = mean_products(settings, speed_m_s, 3, 4);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(product[i]) < 0.05 * 0.05 * kShare);
  }
}

TEST_CASE("without noise the odometry is the truth") {
  const std::string follows = GENERATE("place", "way");
  const OdometrySettings none{"truth+noise", follows, 0.0, 0.0, 20.0, 0.0, 0.0};
  const Line truth(1.0);
  const TruthNoiseOdometry odometry(truth, 0.1, 50, none, 1);
  CHECK(odometry.sweeps() == 50);
  for (const std::int64_t sweep : {0, 20, 49}) {
    const double time_s = 0.1 * static_cast<double>(sweep) + 0.03;
    CHECK(odometry.T_odom_lidar(sweep, time_s).isApprox(truth.T_world_lidar(time_s), 1e-14));
  }
}

TEST_CASE("the error is one and the same within a sweep") {
  const Line truth(1.0);
  const TruthNoiseOdometry odometry(truth, 0.1, 10, OdometrySettings{}, 1);
  const Errors start = errors_at(odometry, truth, 4, 0.4), end = errors_at(odometry, truth, 4, 0.5);
  for (std::size_t i = 0; i < start.size(); ++i) CHECK(start[i] == Approx(end[i]).margin(1e-12));
}

TEST_CASE("the error belongs to seed and sweep, not to the length of the drive") {
  const Line truth(1.0);
  const TruthNoiseOdometry some(truth, 0.1, 20, OdometrySettings{}, 5);
  const TruthNoiseOdometry more(truth, 0.1, 90, OdometrySettings{}, 5);
  const TruthNoiseOdometry other(truth, 0.1, 20, OdometrySettings{}, 6);
  for (std::int64_t sweep = 0; sweep < 20; ++sweep) {
    const double time_s = 0.1 * static_cast<double>(sweep);
    const Eigen::Matrix4d here = some.T_odom_lidar(sweep, time_s).matrix();
    CHECK(here == more.T_odom_lidar(sweep, time_s).matrix());
    CHECK(here != other.T_odom_lidar(sweep, time_s).matrix());
  }
}
