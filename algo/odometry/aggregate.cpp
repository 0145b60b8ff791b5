#include "algo/odometry/aggregate.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// Poses within one sweep: exact at 65 knots, matrices blended linearly between.
///
/// The blend shortens by Δθ²/8, Δθ the turn between two knots: at 1 rad/s and 10 Hz 0.01 µm a
/// metre, far below the 2 mm of a range.
class SweepPoses {
 public:
  SweepPoses(const PosedSweep& posed, double period_s)
      : knots_per_ns_(1e-9 * kIntervals / period_s) {
    const Twist twist = se3_log(posed.T_odom_start.inverse() * posed.T_odom_end);
    still_ = twist.isZero(0.0);
    for (int k = 0; k <= kIntervals; ++k) {
      const Pose3 pose =
          posed.T_odom_start * se3_exp(twist * (static_cast<double>(k) / kIntervals));
      knots_[static_cast<std::size_t>(k)] = pose.matrix().topRows<3>();
    }
  }
  [[nodiscard]] Eigen::Vector3d operator()(std::uint32_t time_offset_ns,
                                           const Eigen::Vector3d& point_m) const {
    if (still_) return transform(knots_.front(), point_m);
    const double at = static_cast<double>(time_offset_ns) * knots_per_ns_;
    const int k = std::clamp(static_cast<int>(at), 0, kIntervals - 1);
    const double share = at - k;
    const auto i = static_cast<std::size_t>(k);
    return (1.0 - share) * transform(knots_[i], point_m) +
           share * transform(knots_[i + 1], point_m);
  }

 private:
  using Matrix34 = Eigen::Matrix<double, 3, 4>;
  static constexpr int kIntervals = 64;
  static Eigen::Vector3d transform(const Matrix34& m, const Eigen::Vector3d& p) {
    return m.leftCols<3>() * p + m.col(3);
  }

  double knots_per_ns_;
  bool still_ = false;
  std::array<Matrix34, kIntervals + 1> knots_;
};

struct Beam {
  double horizontal, vertical, offset_m;
};

std::vector<Beam> beams_of(const LidarModel& model) {
  std::vector<Beam> beams;
  for (const Laser& laser : model.lasers) {
    beams.push_back(
        {std::cos(laser.elevation_rad), std::sin(laser.elevation_rad), laser.vertical_offset_m});
  }
  return beams;
}

template <class Use>
void visit_points(const PosedSweep& posed, const LidarModel& model,
                  const KeyFrameSettings& settings, const Use& use) {
  HONKA_CHECK(posed.sweep != nullptr, "a posed sweep without a sweep");
  const SweepPoses poses(posed, model.sweep_period_s());
  const std::vector<Beam> beams = beams_of(model);
  for (const Return& r : posed.sweep->returns) {
    const double range_m = model.range_resolution_m * r.range_ticks;
    if (r.range_ticks == 0 || range_m < settings.min_range_m || range_m > settings.max_range_m) {
      continue;
    }
    // Sweep::point_in_lidar with the lasers' sines taken once.
    const Beam& beam = beams[r.laser];
    const double azimuth = posed.sweep->azimuth_rad(r, model);
    const double planar_m = range_m * beam.horizontal;
    use(poses(r.time_offset_ns, {planar_m * std::cos(azimuth), -planar_m * std::sin(azimuth),
                                 range_m * beam.vertical + beam.offset_m}));
  }
}

}  // namespace

Pose3 levelled(const Pose3& T_odom_lidar) {
  return pose_from_rpy(T_odom_lidar.translation(), 0.0, 0.0, yaw_of(T_odom_lidar));
}

Eigen::Vector3d for_each_point(const PosedSweep& posed, const LidarModel& model,
                               const KeyFrameSettings& settings,
                               const std::function<void(const Eigen::Vector3d&)>& use) {
  visit_points(posed, model, settings, use);
  return posed.T_odom_start.translation();
}

LocalCloud aggregate(std::span<const PosedSweep> sweeps, const LidarModel& model,
                     const KeyFrameSettings& settings, const Pose3& T_odom_reference) {
  const Pose3 T_local_odom = levelled(T_odom_reference).inverse();
  std::size_t returns = 0;
  for (const PosedSweep& posed : sweeps) returns += posed.sweep->returns.size();
  LocalCloud cloud;
  cloud.points_m.reserve(returns);
  cloud.frames.reserve(returns);
  for (const PosedSweep& posed : sweeps) {
    const PosedSweep local{posed.sweep, T_local_odom * posed.T_odom_start,
                           T_local_odom * posed.T_odom_end};
    const auto frame = static_cast<std::uint32_t>(cloud.origins_m.size());
    visit_points(local, model, settings, [&](const Eigen::Vector3d& point_in_local) {
      cloud.points_m.push_back(point_in_local);
      cloud.frames.push_back(frame);
    });
    cloud.origins_m.push_back(local.T_odom_start.translation());
  }
  return cloud;
}

void CloudMap::add(const LocalCloud& cloud_in_map) {
  const auto first = static_cast<std::uint32_t>(origins_m_.size());
  for (std::size_t i = 0; i < cloud_in_map.size(); ++i) {
    if (voxels_.insert(cloud_in_map.points_m[i])) frames_.push_back(first + cloud_in_map.frames[i]);
  }
  origins_m_.insert(origins_m_.end(), cloud_in_map.origins_m.begin(), cloud_in_map.origins_m.end());
}

LocalCloud CloudMap::cloud() const { return {voxels_.points_m(), frames_, origins_m_}; }

}  // namespace honka
