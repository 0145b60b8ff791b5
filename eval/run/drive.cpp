#include "eval/run/drive.h"

#include "algo/odometry/key_frames.h"
#include "eval/run/truth_noise_odometry.h"

namespace honka::eval {
namespace {

KeyFrame make_key_frame(std::int64_t first_sweep, std::int64_t sweeps, double period_s,
                        const sim::Vehicle& vehicle, const TruthNoiseOdometry& odometry) {
  KeyFrame key_frame;
  key_frame.time_s = period_s * static_cast<double>(first_sweep);
  key_frame.travelled_m = vehicle.travelled_m(key_frame.time_s);
  key_frame.T_odom_lidar = odometry.T_odom_lidar(first_sweep, key_frame.time_s);
  key_frame.T_world_lidar = vehicle.trajectory().T_world_lidar(key_frame.time_s);
  for (std::int64_t k = first_sweep; k < first_sweep + sweeps; ++k) {
    const double start_s = period_s * static_cast<double>(k);
    key_frame.sweeps.push_back(
        {k, odometry.T_odom_lidar(k, start_s), odometry.T_odom_lidar(k, start_s + period_s)});
  }
  return key_frame;
}

}  // namespace

Drive make_drive(const std::string& name, const sim::Polyline& path,
                 const sim::VehicleSettings& vehicle, const Scenario& scenario,
                 const TrialWorld& world) {
  const std::uint64_t seed = derive_seed(world.seed, name);
  Drive drive;
  drive.vehicle = std::make_unique<sim::Vehicle>(path, world.stand.terrain, vehicle, seed);
  const sim::Trajectory& truth = drive.vehicle->trajectory();
  const double period_s = world.lidar->model().sweep_period_s();
  const auto sweeps = static_cast<std::int64_t>(truth.duration_s() / period_s);
  const TruthNoiseOdometry odometry(truth, period_s, sweeps, scenario.odometry, seed);
  KeyFrameSelector selector(scenario.frame);
  for (std::int64_t k = 0; k + scenario.frame.sweeps <= sweeps; ++k) {
    const double time_s = period_s * static_cast<double>(k);
    if (selector.is_key_frame(odometry.T_odom_lidar(k, time_s))) {
      drive.key_frames.push_back(
          make_key_frame(k, scenario.frame.sweeps, period_s, *drive.vehicle, odometry));
    }
  }
  return drive;
}

std::vector<sim::TruthfulSweep> cast_key_frame(const sim::LidarSimulator& lidar, const Drive& drive,
                                               std::size_t key_frame) {
  const double period_s = lidar.model().sweep_period_s();
  std::vector<sim::TruthfulSweep> sweeps;
  for (const FrameSweep& sweep : drive.key_frames[key_frame].sweeps) {
    const double middle_s = period_s * (static_cast<double>(sweep.index) + 0.5);
    const auto occluders = drive.vehicle->occluders_in_lidar(middle_s);
    sweeps.push_back(lidar.cast(drive.vehicle->trajectory(), sweep.index, occluders));
  }
  return sweeps;
}

std::vector<PosedSweep> posed(const KeyFrame& key_frame, const std::vector<Sweep>& sweeps) {
  std::vector<PosedSweep> result;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const FrameSweep& poses = key_frame.sweeps[i];
    result.push_back({&sweeps[i], poses.T_odom_start, poses.T_odom_end});
  }
  return result;
}

std::vector<Sweep> scans_of(std::vector<sim::TruthfulSweep> sweeps) {
  std::vector<Sweep> scans;
  for (sim::TruthfulSweep& sweep : sweeps) scans.push_back(std::move(sweep.sweep));
  return scans;
}

}  // namespace honka::eval
