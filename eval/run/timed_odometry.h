#pragma once

#include <vector>

#include "algo/odometry/odometry.h"

namespace honka::eval {

/// Processor time that the calling thread has used. Seconds.
[[nodiscard]] double thread_cpu_s();

/// An odometry with the processor time of each of its sweeps: what it takes on one core, whatever
/// else the machine does.
class TimedOdometry : public Odometry {
 public:
  /// Keeps `odometry` by reference.
  explicit TimedOdometry(Odometry& odometry) : odometry_(odometry) {}

  [[nodiscard]] OdometryEstimate process(const Sweep& sweep) override;
  [[nodiscard]] bool needs_returns() const override { return odometry_.needs_returns(); }

  /// One a sweep, in the order of the calls.
  [[nodiscard]] const std::vector<double>& times_ms() const { return times_ms_; }
  [[nodiscard]] double cpu_s() const;
  /// Sensor seconds a second of processor time, for sweeps of `period_s`; 0 before the first.
  [[nodiscard]] double real_time_factor(double period_s) const;

 private:
  Odometry& odometry_;
  std::vector<double> times_ms_;
};

}  // namespace honka::eval
