#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "algo/odometry/aggregate.h"
#include "algo/odometry/key_frames.h"
#include "algo/odometry/odometry.h"
#include "algo/stems/extract.h"

namespace honka::eval {

/// A key frame of the edge with the sweeps that its stems are looked for in. No truth in it.
struct EdgeFrame {
  struct PosedScan {
    std::shared_ptr<const Sweep> sweep;
    Pose3 T_odom_start = Pose3::Identity(), T_odom_end = Pose3::Identity();
  };
  double time_s = 0.0;                     ///< start of the first sweep
  Pose3 T_odom_lidar = Pose3::Identity();  ///< at time_s, by the edge's odometry
  std::vector<PosedScan> scans;
};

/// Chooses key frames among the sweeps that the odometry registered, and gathers for each the next
/// `settings.sweeps` of them. Frames may share sweeps; a frame that the drive's end leaves short is
/// dropped.
class EdgeFrameGatherer {
 public:
  explicit EdgeFrameGatherer(const KeyFrameSettings& settings);

  void add(const OdometryEstimate& estimate, Sweep sweep);
  /// Frames that are complete since the last call, in the order of the drive.
  [[nodiscard]] std::vector<EdgeFrame> take_complete();
  [[nodiscard]] std::int64_t unregistered() const { return unregistered_; }

 private:
  std::size_t sweeps_;
  KeyFrameSelector selector_;
  std::deque<EdgeFrame> open_;
  std::vector<EdgeFrame> complete_;
  std::int64_t unregistered_ = 0;
};

/// The stems of a key frame by Algorithm 1 of Li2020, in the lidar's frame at its time: x and y of
/// each stem, at the height of its ground plus `height_above_ground_m` where the settings ask for
/// the height band (which knows the ground), else at its lowest point.
///
/// Algorithm 1 wants z up: the sweeps are gathered in the frame levelled by the odometry's roll and
/// pitch, and the stems are turned back.
[[nodiscard]] std::vector<Eigen::Vector3d> stems_in_lidar(const EdgeFrame& frame,
                                                          const LidarModel& model,
                                                          const KeyFrameSettings& returns,
                                                          const StemSettings& settings,
                                                          double height_above_ground_m);

}  // namespace honka::eval
