#include "algo/odometry/track.h"

#include <algorithm>
#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/types/check.h"

namespace honka {

void OdometryTrack::add(const OdometryEstimate& estimate) {
  if (estimate.status == OdometryStatus::kRefused) return;
  HONKA_CHECK(empty() || estimate.start_time_s > estimates_.back().start_time_s,
              "estimates come in the order of time");
  estimates_.push_back(estimate);
}

const OdometryEstimate& OdometryTrack::at(double time_s) const {
  HONKA_CHECK(!empty() && std::isfinite(time_s), "a time on a track that holds estimates");
  const auto after =
      std::upper_bound(estimates_.begin(), estimates_.end(), time_s,
                       [](double t, const OdometryEstimate& e) { return t < e.start_time_s; });
  return after == estimates_.begin() ? estimates_.front() : *(after - 1);
}

Pose3 OdometryTrack::T_odom_lidar(double time_s) const {
  const OdometryEstimate& e = at(time_s);
  if (time_s <= e.start_time_s) return e.T_odom_start;
  if (time_s <= e.end_time_s) {
    return interpolate(e.T_odom_start, e.T_odom_end,
                       (time_s - e.start_time_s) / (e.end_time_s - e.start_time_s));
  }
  if (&e == &estimates_.back()) return e.T_odom_end;
  const OdometryEstimate& next = *(&e + 1);
  return interpolate(e.T_odom_end, next.T_odom_start,
                     (time_s - e.end_time_s) / (next.start_time_s - e.end_time_s));
}

}  // namespace honka
