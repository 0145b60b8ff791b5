#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "algo/odometry/aggregate.h"
#include "algo/odometry/track.h"
#include "eval/config/scenario.h"
#include "eval/run/trial_world.h"
#include "sim/harvester/vehicle.h"
#include "sim/world/recording.h"

namespace honka::eval {

/// A sweep of a key frame with the odometry's poses at its start and end.
struct FrameSweep {
  std::int64_t index = 0;
  Pose3 T_odom_start = Pose3::Identity();
  Pose3 T_odom_end = Pose3::Identity();
};

/// A place that the odometry found worth keeping, with the truth of it for the metrics.
struct KeyFrame {
  std::vector<FrameSweep> sweeps;
  double time_s = 0.0;                      ///< start of the first sweep
  double travelled_m = 0.0;                 ///< along the path
  Pose3 T_odom_lidar = Pose3::Identity();   ///< at time_s
  Pose3 T_world_lidar = Pose3::Identity();  ///< truth at time_s
};

/// A vehicle's drive and what its odometry made of it.
struct Drive {
  std::unique_ptr<sim::Vehicle> vehicle;
  OdometryTrack track;  ///< every sweep
  std::vector<KeyFrame> key_frames;
  /// Lays the odometry's frame onto the world, for the metrics alone: yaw and translation that
  /// bring its key frames nearest to the truth. The identity for truth+noise, whose frame is the
  /// world but for its errors.
  Pose3 T_world_odom = Pose3::Identity();
};

/// Which drive: `name` tells its random streams from those of another.
struct DriveOrder {
  std::string name;
  const sim::Polyline* path = nullptr;
  const sim::VehicleSettings* vehicle = nullptr;
  const SeenStand* stand = nullptr;
};

/// The prior run's and the localized run's.
[[nodiscard]] DriveOrder prior_drive(const Scenario& scenario, const TrialWorld& world);
[[nodiscard]] DriveOrder work_drive(const Scenario& scenario, const TrialWorld& world);

/// The vehicle of a drive alone; `seed` is the trial's.
[[nodiscard]] std::unique_ptr<sim::Vehicle> make_vehicle(const DriveOrder& order,
                                                         std::uint64_t seed);

/// Takes each key frame in the order of the drive, with its sweeps and their truth.
using TakeKeyFrame = std::function<void(const KeyFrame&, std::vector<sim::TruthfulSweep>&&)>;

/// Key frames of a drive, counted from 0.
struct KeyFrameChoice {
  std::size_t first = 0;
  std::size_t count = static_cast<std::size_t>(-1);  ///< all that follow

  [[nodiscard]] bool holds(std::size_t number) const {
    return number >= first && number - first < count;
  }
};

/// Drives a path with the scenario's odometry. A lidar odometry gets every sweep as it is cast;
/// truth+noise needs none, so the sweeps of key frames alone are cast. Sweeps that could not be
/// registered are in no key frame. Key frames outside `choice` are left out, as if the odometry had
/// not found them worth keeping. `what` leads the line of progress; none is shown where it is
/// empty.
[[nodiscard]] Drive drive_and_scan(const DriveOrder& order, const Scenario& scenario,
                                   std::uint64_t seed, const std::string& what, int threads,
                                   const TakeKeyFrame& take, const KeyFrameChoice& choice = {});

/// The sweeps of a key frame with their poses; points into `sweeps`.
[[nodiscard]] std::vector<PosedSweep> posed(const KeyFrame& key_frame,
                                            const std::vector<Sweep>& sweeps);

/// The scans alone, without their truth.
[[nodiscard]] std::vector<Sweep> scans_of(std::vector<sim::TruthfulSweep> sweeps);

}  // namespace honka::eval
