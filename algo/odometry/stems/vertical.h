#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "algo/odometry/aggregate.h"
#include "algo/odometry/stems/settings.h"
#include "algo/types/lidar_model.h"
#include "algo/types/pose.h"

namespace honka {

enum class VerticalSource : std::uint8_t {
  kStems,    ///< the mean of the axes of stems
  kGround,   ///< the normal of the ground around the machine
  kAssumed,  ///< nothing to go by: z of the frame
};

struct VerticalEstimate {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< unit, in the frame of the poses given
  double sigma_rad = 0.0;                         ///< s.d. about each of two horizontal axes
  std::int64_t stems = 0;                         ///< different stems behind it
  VerticalSource source = VerticalSource::kAssumed;
};

/// The direction against gravity, from one or a few sweeps with their poses, without any prior.
///
/// Trees lean to all sides, so the mean of their axes stands: least squares over one axis a stem,
/// with Tukey weights. A stem tapers, and its near side, which is what the lidar sees, leans away;
/// the same fit has that outward slope as its third unknown. With fewer than `min_stems` stems the
/// normal of a plane through the near ground, its s.d. the slope of terrain; with no ground either,
/// z and 45°. For one sweep of a lidar that may move, give it equal poses, as {&sweep, I, I}: up is
/// then in the lidar frame. The frame of the poses must be within 30° of upright.
[[nodiscard]] VerticalEstimate estimate_vertical(std::span<const PosedSweep> sweeps,
                                                 const LidarModel& model,
                                                 const VerticalSettings& settings = {});

/// Pose of the lidar in a frame with z up, its origin at the lidar and x along its heading, for
/// `up` in the lidar frame: the start of an odometry.
[[nodiscard]] Pose3 levelled_start(const Eigen::Vector3d& up_in_lidar);

}  // namespace honka
