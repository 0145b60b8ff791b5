#pragma once

#include <cstdint>
#include <optional>

#include "algo/odometry/odometry.h"
#include "algo/types/lidar_model.h"
#include "algo/types/sweep.h"

namespace honka {

/// Judges, before any registration, whether a sweep can follow the last one.
class SweepOrder {
 public:
  explicit SweepOrder(const LidarModel& model) : period_s_(model.sweep_period_s()) {}

  struct Verdict {
    OdometryCause cause = OdometryCause::kNone;
    bool placed = true;      ///< false: the sweep has no place in time
    double elapsed_s = 0.0;  ///< since the last placed sweep's start; 0 for the first
  };

  /// In this order: not_finite, repeated_time and reversed_time (not placed), gap (more than one
  /// and a half periods since the last), empty_scan (no return of range above 0). A sweep that is
  /// placed becomes the last one.
  [[nodiscard]] Verdict judge(const Sweep& sweep);

 private:
  double period_s_;
  std::optional<double> last_start_s_;
};

}  // namespace honka
