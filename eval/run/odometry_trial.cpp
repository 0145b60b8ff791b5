#include "eval/run/odometry_trial.h"

#include <memory>

#include "algo/types/random.h"
#include "eval/run/odometry_drive.h"
#include "eval/run/timed_odometry.h"

namespace honka::eval {
namespace {

/// An odometry at work on a drive, and what it has made so far.
struct Driver {
  std::unique_ptr<Odometry> odometry;
  std::unique_ptr<TimedOdometry> timed;
  OdometryRun run;
};

std::vector<Driver> make_drivers(const Scenario& scenario, const NamedStand& stand,
                                 std::int64_t trial, const LidarModel& model) {
  std::vector<Driver> drivers;
  for (const std::string& name : odometries_of(scenario)) {
    Driver driver;
    driver.odometry = create_odometry(name, model, scenario.odometry.lidar);
    driver.timed = std::make_unique<TimedOdometry>(*driver.odometry);
    driver.run.stand = stand.name;
    driver.run.odometry = name;
    driver.run.trial = trial;
    driver.run.period_s = model.sweep_period_s();
    drivers.push_back(std::move(driver));
  }
  return drivers;
}

void take(Driver& driver, const Sweep& sweep, const sim::Vehicle& vehicle) {
  OdometryRun& run = driver.run;
  run.estimates.push_back(driver.timed->process(sweep));
  run.pairs.poses.push_back({sweep.start_time_s,
                             vehicle.trajectory().T_world_lidar(sweep.start_time_s),
                             run.estimates.back().T_odom_start});
  run.driven_m.push_back(vehicle.travelled_m(sweep.start_time_s));
}

}  // namespace

std::vector<std::string> odometries_of(const Scenario& scenario) {
  const std::string& asked = scenario.stands.odometries;
  return asked == "all" ? odometry_names() : std::vector<std::string>{asked};
}

std::vector<OdometryRun> run_odometry_trial(const Scenario& scenario, const NamedStand& stand,
                                            std::int64_t trial, int threads,
                                            const std::string& what) {
  const TrialWorld world = make_stand_world(scenario, stand, trial);
  const sim::Vehicle vehicle(world.work_path, world.stand.terrain, scenario.harvester,
                             derive_seed(world.seed, "work"));
  std::vector<Driver> drivers = make_drivers(scenario, stand, trial, world.lidar->model());
  Progress progress(what, "sweeps", sweeps_of(vehicle, world.lidar->model()));
  stream_sweeps(vehicle, *world.lidar, threads, progress, [&](sim::TruthfulSweep&& sweep) {
    for (Driver& driver : drivers) take(driver, sweep.sweep, vehicle);
  });
  std::vector<OdometryRun> runs;
  for (Driver& driver : drivers) {
    driver.run.times_ms = driver.timed->times_ms();
    runs.push_back(std::move(driver.run));
  }
  return runs;
}

}  // namespace honka::eval
