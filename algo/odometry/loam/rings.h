#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/types/lidar_model.h"
#include "algo/types/sweep.h"

namespace honka {

/// A return on its ring.
struct RingPoint {
  Eigen::Vector3d point_m = Eigen::Vector3d::Zero();  ///< lidar frame at its own time
  double range_m = 0.0;
  double share = 0.0;       ///< of the revolution that had passed
  std::int32_t firing = 0;  ///< number of the firing within the sweep
};

using Ring = std::vector<RingPoint>;

/// The first echoes of each laser in the order of time; rings in the order of laser ids.
struct Rings {
  std::vector<Ring> of_laser;
  std::int32_t first_firing = 0;  ///< of the view: the first and last that was shot, with or
  std::int32_t last_firing = -1;  ///< without a return
};

/// Leaves out unknown lasers, echoes after the first, and times beyond one and a half revolutions;
/// range 0 is a shot without a return.
[[nodiscard]] Rings rings_of(const Sweep& sweep, const LidarModel& model);

/// Turn of the sensor between two firings.
[[nodiscard]] double azimuth_step_rad(const LidarModel& model);

/// Points begin … end − 1 of a ring that follow each other without a step in depth.
struct Run {
  std::size_t begin = 0, end = 0;
  bool free_begin = false;  ///< what lies beside it is farther away, or nothing
  bool free_end = false;
  bool alone = false;  ///< beside one of its ends, within the view, is nothing at all
  [[nodiscard]] std::size_t size() const { return end - begin; }
};

/// Runs of a ring within the view: `first_firing` … `last_firing`. What lies beyond is not known,
/// so a run that reaches its rim is not free there.
[[nodiscard]] std::vector<Run> runs_of(const Ring& ring, double depth_step_m,
                                       std::int32_t first_firing, std::int32_t last_firing);

/// Zhang2014 Eq. (1) at point i with the 5 points before and after it; fewer at the ring's ends.
[[nodiscard]] double curvature_at(const Ring& ring, std::size_t i);

}  // namespace honka
