#include "eval/run/slam/slam_drive.h"

#include <algorithm>
#include <numeric>

#include "algo/types/random.h"
#include "eval/run/make_odometry.h"
#include "eval/run/odometry_drive.h"
#include "eval/run/parallel.h"
#include "eval/run/slam/edge_frames.h"
#include "eval/run/slam/slam_world.h"
#include "sim/harvester/vehicle.h"

namespace honka::eval {
namespace {

/// Sweeps that are cast before the stems of the key frames among them are looked for: bounds the
/// memory to some 30 MB and keeps all threads at one kind of work.
constexpr std::int64_t kSweepsAtOnce = 128;

KeyFrameSettings slam_key_frames(const Scenario& scenario) {
  KeyFrameSettings settings = scenario.frame;
  settings.distance_m = scenario.slam.keyframe.distance_m;
  settings.angle_deg = scenario.slam.keyframe.angle_deg;
  return settings;
}

/// The stems of each key frame, in the order of the frames.
std::vector<std::vector<Eigen::Vector3d>> find_stems(const std::vector<EdgeFrame>& frames,
                                                     const LidarModel& model,
                                                     const Scenario& scenario, int threads) {
  std::vector<std::vector<Eigen::Vector3d>> stems(frames.size());
  for_each_index(frames.size(), threads, [&](std::size_t i) {
    stems[i] =
        stems_in_lidar(frames[i], model, scenario.frame, scenario.stems, kStemReferenceHeight_m);
  });
  return stems;
}

/// Appends key frames as the cloud gets them; their poses are still in the odometry's and the
/// world's frames.
void append_frames(const std::vector<EdgeFrame>& frames,
                   std::vector<std::vector<Eigen::Vector3d>> stems, const sim::Vehicle& vehicle,
                   SlamDrive& drive) {
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const double time_s = frames[i].time_s;
    drive.frames.push_back({static_cast<std::int64_t>(drive.frames.size()), std::move(stems[i])});
    drive.edge_T_first_frame.push_back(frames[i].T_odom_lidar);
    drive.true_T_first_frame.push_back(vehicle.trajectory().T_world_lidar(time_s));
    drive.times_s.push_back(time_s);
    drive.travelled_m.push_back(vehicle.travelled_m(time_s));
  }
}

void relate_to_first(FramePoses& poses) {
  if (poses.empty()) return;
  const Pose3 T_first_base = poses.front().inverse();
  for (Pose3& pose : poses) pose = T_first_base * pose;
  poses.front() = Pose3::Identity();
}

std::vector<Eigen::Vector3d> stems_of(const sim::Stand& stand, const Pose3& T_first_world) {
  std::vector<Eigen::Vector3d> stems_in_first;
  for (const Stem& stem : true_stems(stand)) {
    const Eigen::Vector2d& p = stem.position_m;
    const double z_m = stem.z_m.value_or(0.0) + kStemReferenceHeight_m;
    stems_in_first.emplace_back(T_first_world * Eigen::Vector3d(p.x(), p.y(), z_m));
  }
  return stems_in_first;
}

void add_truth(const SlamWorld& world, SlamDrive& drive) {
  drive.trees_on_strip = trees_on_strip(world.stand);
  if (drive.frames.empty()) return;
  drive.true_stems_in_first_m = stems_of(world.stand, drive.true_T_first_frame.front().inverse());
  relate_to_first(drive.true_T_first_frame);
  relate_to_first(drive.edge_T_first_frame);
}

}  // namespace

SlamDrive drive_for_slam(const Scenario& scenario, std::int64_t trial, int threads,
                         const std::string& what) {
  const SlamWorld world = make_slam_world(scenario, trial);
  const LidarModel& model = world.lidar->model();
  const std::uint64_t seed = derive_seed(world.seed, "slam_drive");
  const sim::Vehicle vehicle(world.road, world.stand.terrain, scenario.harvester, seed);
  SlamDrive drive;
  drive.sweeps = sweeps_of(vehicle, model);
  drive.duration_s = vehicle.trajectory().duration_s();
  const auto odometry =
      make_odometry(scenario.odometry, vehicle.trajectory(), model, drive.sweeps, seed);
  EdgeFrameGatherer gatherer(slam_key_frames(scenario));
  Progress progress(what, "sweeps", drive.sweeps);
  for (std::int64_t first = 0; first < drive.sweeps; first += kSweepsAtOnce) {
    std::vector<std::int64_t> indices(
        static_cast<std::size_t>(std::min(kSweepsAtOnce, drive.sweeps - first)));
    std::iota(indices.begin(), indices.end(), first);
    stream_sweeps(vehicle, *world.lidar, indices, threads, progress,
                  [&](sim::TruthfulSweep&& sweep) {
                    const OdometryEstimate estimate = odometry->process(sweep.sweep);
                    gatherer.add(estimate, std::move(sweep.sweep));
                  });
    const auto frames = gatherer.take_complete();
    append_frames(frames, find_stems(frames, model, scenario, threads), vehicle, drive);
  }
  drive.unregistered_sweeps = gatherer.unregistered();
  add_truth(world, drive);
  return drive;
}

}  // namespace honka::eval
