#include "eval/run/odometry_drive.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "eval/run/make_odometry.h"
#include "eval/run/timed_odometry.h"
#include "eval/run/truth_noise_odometry.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// A bare plane with a few posts, and a machine that drives 3 m over it.
struct SmallWorld {
  sim::World world;
  sim::Heightfield ground{{-30.0, -30.0}, 30.0, 3, 3, std::vector<double>(9, 0.0)};
  sim::VehicleSettings settings;
  std::unique_ptr<sim::Vehicle> vehicle;
  std::unique_ptr<sim::LidarSimulator> lidar;

  SmallWorld() {
    sim::TriangleMesh mesh = ground.mesh();
    mesh.label.part = sim::Part::kGround;
    world.meshes.push_back(mesh);
    for (int i = 0; i < 6; ++i) {
      const double x = 4.0 * i - 8.0, y = i % 2 == 0 ? 5.0 : -6.0;
      world.cones.push_back({{x, y, 0.0}, {x, y, 12.0}, 0.15, 0.1, {i, sim::Part::kStem}});
    }
    settings.work_cycle = false;
    vehicle =
        std::make_unique<sim::Vehicle>(sim::Polyline{{0.0, 0.0}, {3.0, 0.0}}, ground, settings, 1);
    lidar = std::make_unique<sim::LidarSimulator>(world, sim::LidarSettings{}, 1);
  }
};

/// Writes down what it is given.
class Witness : public Odometry {
 public:
  [[nodiscard]] OdometryEstimate process(const Sweep& sweep) override {
    seen.push_back(sweep);
    OdometryEstimate estimate;
    estimate.sweep = sweep.index;
    estimate.start_time_s = sweep.start_time_s;
    estimate.end_time_s = sweep.start_time_s + 0.1;
    return estimate;
  }
  std::vector<Sweep> seen;
};

bool same(const Sweep& a, const Sweep& b) {
  return a.index == b.index && a.start_time_s == b.start_time_s && a.returns == b.returns;
}

Sweep sweep_at(std::int64_t index, double time_s) {
  Sweep sweep;
  sweep.index = index;
  sweep.start_time_s = time_s;
  return sweep;
}

}  // namespace

TEST_CASE("a drive's sweeps reach the odometry in order, the same on any number of threads") {
  const SmallWorld small;
  std::vector<Sweep> alone;
  for (const int threads : {1, 2, 5}) {
    CAPTURE(threads);
    Progress progress("drive", "sweeps", sweeps_of(*small.vehicle, small.lidar->model()));
    Witness witness;
    std::vector<std::int64_t> kept;
    const OdometryTrack track = drive_with_odometry(
        *small.vehicle, *small.lidar, witness, threads, progress, [&](DriveSweep&& sweep) {
          CHECK(sweep.estimate.sweep == sweep.sweep.sweep.index);
          CHECK(sweep.sweep.truth.size() == sweep.sweep.sweep.returns.size());
          kept.push_back(sweep.estimate.sweep);
        });
    REQUIRE(witness.seen.size() ==
            static_cast<std::size_t>(sweeps_of(*small.vehicle, small.lidar->model())));
    CHECK(track.estimates().size() == witness.seen.size());
    for (std::size_t i = 0; i < kept.size(); ++i) CHECK(kept[i] == static_cast<std::int64_t>(i));
    if (alone.empty()) alone = witness.seen;
    for (std::size_t i = 0; i < alone.size(); ++i) CHECK(same(alone[i], witness.seen[i]));
  }
}

TEST_CASE("chosen sweeps alone are cast, and what their taker throws comes out") {
  const SmallWorld small;
  Progress progress("drive", "sweeps", 3);
  std::vector<std::int64_t> taken;
  stream_sweeps(*small.vehicle, *small.lidar, {2, 7, 11}, 2, progress,
                [&](sim::TruthfulSweep&& sweep) { taken.push_back(sweep.sweep.index); });
  CHECK(taken == std::vector<std::int64_t>{2, 7, 11});
  CHECK_THROWS_AS(stream_sweeps(*small.vehicle, *small.lidar, {1, 2, 3}, 2, progress,
                                [](sim::TruthfulSweep&&) { throw std::runtime_error("full"); }),
                  std::runtime_error);
}

TEST_CASE("truth and noise stands behind the interface: no ray is cast for it") {
  const SmallWorld small;
  const sim::Trajectory& truth = small.vehicle->trajectory();
  const std::int64_t sweeps = sweeps_of(*small.vehicle, small.lidar->model());
  const auto odometry = make_odometry({}, truth, small.lidar->model(), sweeps, 4);
  CHECK_FALSE(odometry->needs_returns());
  Progress progress("drive", "sweeps", sweeps);
  const OdometryTrack track =
      drive_with_odometry(*small.vehicle, *small.lidar, *odometry, 2, progress,
                          [](DriveSweep&& sweep) { CHECK(sweep.sweep.sweep.returns.empty()); });
  const TruthNoiseOdometry poses(truth, 0.1, sweeps, {}, 4);
  REQUIRE(track.estimates().size() == static_cast<std::size_t>(sweeps));
  for (const OdometryEstimate& e : track.estimates()) {
    CHECK(e.status == OdometryStatus::kRegistered);
    CHECK(e.T_odom_start.matrix() == poses.T_odom_lidar(e.sweep, e.start_time_s).matrix());
    CHECK(e.T_odom_end.matrix() == poses.T_odom_lidar(e.sweep, e.end_time_s).matrix());
  }
}

TEST_CASE("truth and noise answers bad times with a cause and a finite pose") {
  const SmallWorld small;
  TruthNoiseOdometry odometry(small.vehicle->trajectory(), 0.1, 20, {}, 1);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto check = [&](const Sweep& sweep, OdometryStatus status, OdometryCause cause) {
    const OdometryEstimate e = odometry.process(sweep);
    CHECK(e.status == status);
    CHECK(e.cause == cause);
    CHECK(e.T_odom_start.matrix().allFinite());
    CHECK(e.T_odom_end.matrix().allFinite());
    CHECK(std::isfinite(e.end_time_s));
  };
  check(sweep_at(0, kNan), OdometryStatus::kRefused, OdometryCause::kNotFinite);
  check(sweep_at(3, 0.3), OdometryStatus::kRegistered, OdometryCause::kNone);
  check(sweep_at(3, 0.3), OdometryStatus::kRefused, OdometryCause::kRepeatedTime);
  check(sweep_at(2, 0.2), OdometryStatus::kRefused, OdometryCause::kReversedTime);
  check(sweep_at(9, 0.9), OdometryStatus::kRegistered, OdometryCause::kNone);
  check(sweep_at(500, 50.0), OdometryStatus::kRegistered, OdometryCause::kNone);
}

TEST_CASE("every source of the scenario is made, and its time is measured") {
  const SmallWorld small;
  for (const std::string source : {"truth+noise", "loam", "stems"}) {
    CAPTURE(source);
    OdometrySettings settings;
    settings.source = source;
    const auto odometry =
        make_odometry(settings, small.vehicle->trajectory(), small.lidar->model(), 5, 1);
    CHECK(odometry->needs_returns() == (source != "truth+noise"));
    TimedOdometry timed(*odometry);
    CHECK(timed.real_time_factor(0.1) == 0.0);
    for (std::int64_t k = 0; k < 3; ++k) {
      CHECK(timed.process(cast_sweep(*small.vehicle, *small.lidar, k).sweep).sweep == k);
    }
    CHECK(timed.times_ms().size() == 3);
    CHECK(timed.cpu_s() > 0.0);
    CHECK(timed.real_time_factor(0.1) == Approx(0.3 / timed.cpu_s()));
  }
}
