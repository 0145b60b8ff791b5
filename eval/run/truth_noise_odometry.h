#pragma once

#include <vector>

#include "algo/types/pose.h"
#include "algo/types/settings.h"
#include "sim/world/trajectory.h"

namespace honka::eval {

/// Odometry made of truth and noise, for studies and until a lidar odometry takes its place.
///
/// The error of a pose is a slow drift, a stationary first-order Gauss–Markov process over the
/// distance travelled, and an independent jitter of every sweep (what one scan-to-map registration
/// leaves). The drift is planar: x, y and yaw about the sensor.
struct OdometrySettings {
  std::string source = "truth+noise";
  double drift_m = 0.10;             ///< s.d. of each of x and y
  double drift_deg = 0.10;           ///< s.d. of yaw
  double correlation_length_m = 50;  ///< of the drift
  double jitter_m = 0.01;            ///< s.d. of each of x, y, z, of each key frame
  double jitter_deg = 0.05;          ///< s.d. of each of roll, pitch, yaw, of each key frame
};

void describe(SettingsVisitor& v, OdometrySettings& s);

/// Poses that an odometry would report for every sweep of a drive.
class TruthNoiseOdometry {
 public:
  /// `sweeps` sweeps of `period_s`; the odometry frame is the world but for drift and jitter.
  TruthNoiseOdometry(const sim::Trajectory& truth, double period_s, std::int64_t sweeps,
                     const OdometrySettings& settings, std::uint64_t seed);

  /// Pose at a time within sweep `sweep` (its start to its end).
  [[nodiscard]] Pose3 T_odom_lidar(std::int64_t sweep, double time_s) const;
  [[nodiscard]] std::int64_t sweeps() const { return static_cast<std::int64_t>(errors_.size()); }

 private:
  struct Error {
    Eigen::Vector3d translation_m;
    Eigen::Matrix3d rotation;  ///< applied in the odometry frame, about the sensor
  };
  const sim::Trajectory& truth_;
  std::vector<Error> errors_;
};

}  // namespace honka::eval
