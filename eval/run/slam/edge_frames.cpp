#include "eval/run/slam/edge_frames.h"

#include <utility>

namespace honka::eval {

EdgeFrameGatherer::EdgeFrameGatherer(const KeyFrameSettings& settings)
    : sweeps_(static_cast<std::size_t>(settings.sweeps)), selector_(settings) {}

void EdgeFrameGatherer::add(const OdometryEstimate& estimate, Sweep sweep) {
  const bool registered = estimate.status == OdometryStatus::kRegistered ||
                          estimate.status == OdometryStatus::kDegenerate;
  if (!registered) {
    ++unregistered_;
    return;
  }
  if (selector_.is_key_frame(estimate.T_odom_start)) {
    open_.push_back({estimate.start_time_s, estimate.T_odom_start, {}});
  }
  const auto shared = std::make_shared<const Sweep>(std::move(sweep));
  for (EdgeFrame& frame : open_) {
    frame.scans.push_back({shared, estimate.T_odom_start, estimate.T_odom_end});
  }
  while (!open_.empty() && open_.front().scans.size() == sweeps_) {
    complete_.push_back(std::move(open_.front()));
    open_.pop_front();
  }
}

std::vector<EdgeFrame> EdgeFrameGatherer::take_complete() { return std::exchange(complete_, {}); }

std::vector<Eigen::Vector3d> stems_in_lidar(const EdgeFrame& frame, const LidarModel& model,
                                            const KeyFrameSettings& returns,
                                            const StemSettings& settings,
                                            double height_above_ground_m) {
  std::vector<PosedSweep> posed;
  for (const EdgeFrame::PosedScan& scan : frame.scans) {
    posed.push_back({scan.sweep.get(), scan.T_odom_start, scan.T_odom_end});
  }
  const LocalCloud cloud_in_local = aggregate(posed, model, returns, frame.T_odom_lidar);
  const Pose3 T_lidar_local = frame.T_odom_lidar.inverse() * levelled(frame.T_odom_lidar);
  const double above_m = settings.height_band ? height_above_ground_m : 0.0;
  std::vector<Eigen::Vector3d> stems;
  for (const ObservedStem& stem : extract_stems(cloud_in_local, settings).stems) {
    const Eigen::Vector2d& p = stem.position_m;
    stems.emplace_back(T_lidar_local * Eigen::Vector3d(p.x(), p.y(), stem.z_m + above_m));
  }
  return stems;
}

}  // namespace honka::eval
