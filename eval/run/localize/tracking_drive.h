#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "algo/types/pose.h"
#include "eval/config/scenario.h"

namespace honka::eval {

/// The odometry's pose at the start of a sweep, with the truth of it for the metrics alone.
struct TrackedScan {
  double time_s = 0.0;
  Pose2 T_odom_lidar;                                    ///< planar part of the levelled pose
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< what the odometry states of it
  Pose2 T_world_lidar;                                   ///< truth
};

/// The stems that the last frames of a drive show, in the levelled frame of the last one's lidar.
struct TrackedView {
  std::size_t scan = 0;  ///< of the last frame, index into the scans
  /// One list for each of tracking.study.frames.
  std::vector<std::vector<Eigen::Vector2d>> stems_in_local_m;
};

/// A drive in two parts: at `kidnapped_s` the machine is carried elsewhere, unseen by its odometry.
struct TrackingDrive {
  std::vector<TrackedScan> scans;
  std::vector<TrackedView> views;
  std::vector<Eigen::Vector2d> map_m;     ///< stems of the map, its hole cut out
  std::vector<Eigen::Vector2d> hidden_m;  ///< those in the hole, for the figure
  double kidnapped_s = -1.0;              ///< negative: never
  double carried_m = 0.0;
};

/// Drives and casts both parts, finds the stems of the frames that are to be localized, and makes
/// the map of map.source = inventory | airborne. The digits depend on (scenario, trial) alone.
/// UserError at another source.
[[nodiscard]] TrackingDrive make_tracking_drive(const Scenario& scenario, std::int64_t trial,
                                                int threads);

}  // namespace honka::eval
