#include "algo/types/sweep.h"

#include "algo/types/angles.h"

namespace honka {

double Sweep::azimuth_rad(const Return& r, const LidarModel& model) const {
  return start_azimuth_rad +
         2.0 * kPi * model.rotation_rate_hz * 1e-9 * static_cast<double>(r.time_offset_ns);
}

Eigen::Vector3d Sweep::point_in_lidar(const Return& r, const LidarModel& model) const {
  return model.origin(r.laser) + (model.range_resolution_m * static_cast<double>(r.range_ticks)) *
                                     model.direction(r.laser, azimuth_rad(r, model));
}

}  // namespace honka
