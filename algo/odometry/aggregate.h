#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "algo/geometry/voxel_grid.h"
#include "algo/odometry/key_frames.h"
#include "algo/types/lidar_model.h"
#include "algo/types/local_cloud.h"
#include "algo/types/pose.h"
#include "algo/types/sweep.h"

namespace honka {

/// A sweep with the odometry's pose at its first firing and one revolution later.
///
/// Equal poses mean: do not compensate the motion within the sweep.
struct PosedSweep {
  const Sweep* sweep = nullptr;
  Pose3 T_odom_start = Pose3::Identity();  ///< T_odom_lidar at Sweep::start_time_s
  Pose3 T_odom_end = Pose3::Identity();    ///< T_odom_lidar one LidarModel::sweep_period_s later
};

/// The frame of a local cloud: origin at the sensor, x along the sensor's heading, z up.
///
/// Roll and pitch are the odometry's, which knows gravity; the yaw stays the sensor's.
[[nodiscard]] Pose3 levelled(const Pose3& T_odom_lidar);

/// Hands every return of a sweep with min ≤ range ≤ max to `use`: the point in the frame of the
/// poses, each from the pose at its own firing time (constant body twist between start and end).
/// Returns the place of the sensor at the sweep's start. Returns of range 0 are no points.
Eigen::Vector3d for_each_point(const PosedSweep& posed, const LidarModel& model,
                               const KeyFrameSettings& settings,
                               const std::function<void(const Eigen::Vector3d&)>& use);

/// Points of one or more sweeps in the levelled frame of the reference key frame (Li2020, 2.6).
///
/// `T_odom_reference` is the pose T_odom_lidar of that key frame, usually the last. Each sweep is
/// one entry of LocalCloud::origins_m, in the order given.
[[nodiscard]] LocalCloud aggregate(std::span<const PosedSweep> sweeps, const LidarModel& model,
                                   const KeyFrameSettings& settings, const Pose3& T_odom_reference);

/// The point cloud of a whole run, thinned while it grows: thousands of key frames in memory that
/// follows the surface seen, not the returns.
class CloudMap {
 public:
  explicit CloudMap(double voxel_m) : voxels_(voxel_m) {}
  /// Adds points that are in the map frame already: `aggregate` with the identity as reference.
  void add(const LocalCloud& cloud_in_map);
  [[nodiscard]] std::size_t size() const { return voxels_.size(); }
  /// The first point of each voxel, with the sweep that saw it, in the map frame.
  [[nodiscard]] LocalCloud cloud() const;

 private:
  VoxelGrid voxels_;
  std::vector<std::uint32_t> frames_;
  std::vector<Eigen::Vector3d> origins_m_;
};

}  // namespace honka
