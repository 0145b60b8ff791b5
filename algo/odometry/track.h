#pragma once

#include <vector>

#include "algo/odometry/odometry.h"

namespace honka {

/// T_odom_lidar(t) over a run: the estimates of an odometry in the order of time.
class OdometryTrack {
 public:
  /// Estimates that were refused have no time of their own and are left out.
  void add(const OdometryEstimate& estimate);

  [[nodiscard]] bool empty() const { return estimates_.empty(); }
  [[nodiscard]] const std::vector<OdometryEstimate>& estimates() const { return estimates_; }

  /// Pose at a time: constant body twist within a sweep and across a gap; before the first and
  /// after the last sweep the nearest end. A failed check on an empty track or a time that is no
  /// number.
  [[nodiscard]] Pose3 T_odom_lidar(double time_s) const;
  /// The estimate of the sweep that a time falls into, or the last one before it.
  [[nodiscard]] const OdometryEstimate& at(double time_s) const;

 private:
  std::vector<OdometryEstimate> estimates_;
};

}  // namespace honka
