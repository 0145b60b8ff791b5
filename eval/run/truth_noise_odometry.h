#pragma once

#include <vector>

#include "algo/types/pose.h"
#include "eval/config/experiment_settings.h"
#include "sim/world/trajectory.h"

namespace honka::eval {

/// Odometry made of truth and noise, for studies and until a lidar odometry takes its place.
/// The poses that it reports for every sweep of a drive; the model of its error stands beside
/// OdometrySettings.
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
