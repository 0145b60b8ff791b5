#pragma once

#include <memory>
#include <vector>

#include "algo/odometry/odometry.h"
#include "algo/types/pose.h"
#include "eval/config/experiment_settings.h"
#include "sim/world/trajectory.h"

namespace honka::eval {

/// Odometry made of truth and noise, for studies that ask what an odometry's error costs.
/// The poses that it reports for every sweep of a drive; the model of its error stands beside
/// OdometrySettings. Unlike that of a lidar odometry, its frame is the world, but for drift and
/// jitter. The error of a sweep is worked out when it is first asked for: one thread at a time.
class TruthNoiseOdometry : public Odometry {
 public:
  /// `sweeps` sweeps of `period_s`. Keeps `truth` by reference.
  TruthNoiseOdometry(const sim::Trajectory& truth, double period_s, std::int64_t sweeps,
                     const OdometrySettings& settings, std::uint64_t seed);
  ~TruthNoiseOdometry() override;

  /// Answers by the sweep's index and times. A time that is no number, repeated or reversed is
  /// refused; a sweep outside the drive has the error of the nearest one in it.
  [[nodiscard]] OdometryEstimate process(const Sweep& sweep) override;
  [[nodiscard]] bool needs_returns() const override { return false; }

  /// Pose at a time within sweep `sweep` (its start to its end).
  [[nodiscard]] Pose3 T_odom_lidar(std::int64_t sweep, double time_s) const;
  [[nodiscard]] std::int64_t sweeps() const { return sweeps_; }

 private:
  struct Error {
    Eigen::Vector3d translation_m;
    Eigen::Matrix3d rotation;  ///< applied in the odometry frame, about the sensor
  };
  class Drift;
  class DriftAlongWay;
  class DriftOfPlace;
  [[nodiscard]] const Error& error_of(std::int64_t sweep) const;
  [[nodiscard]] OdometryCause place_in_time(double start_time_s) const;

  const sim::Trajectory& truth_;
  double period_s_;
  std::int64_t sweeps_;
  OdometrySettings settings_;
  std::uint64_t seed_;
  Covariance6 covariance_;  ///< of the jitter
  std::unique_ptr<Drift> drift_;
  mutable std::vector<Error> errors_;  ///< of the first sweeps
  OdometryEstimate last_;
  bool started_ = false;
};

}  // namespace honka::eval
