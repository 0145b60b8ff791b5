#include "eval/run/timed_odometry.h"

#include <ctime>
#include <numeric>

namespace honka::eval {

double thread_cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

OdometryEstimate TimedOdometry::process(const Sweep& sweep) {
  const double start_s = thread_cpu_s();
  OdometryEstimate estimate = odometry_.process(sweep);
  times_ms_.push_back(1e3 * (thread_cpu_s() - start_s));
  return estimate;
}

double TimedOdometry::cpu_s() const {
  return 1e-3 * std::accumulate(times_ms_.begin(), times_ms_.end(), 0.0);
}

double TimedOdometry::real_time_factor(double period_s) const {
  const double spent_s = cpu_s();
  return spent_s > 0.0 ? period_s * static_cast<double>(times_ms_.size()) / spent_s : 0.0;
}

}  // namespace honka::eval
