#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "algo/types/pose.h"

namespace honka {

/// The stems of one key frame as the edge sends them: a sparse cloud in the lidar's frame (x ahead,
/// y left, z up), one point a stem. Metres. Any number of points, also none.
struct SparseFrame {
  std::int64_t number = 0;  ///< of the key frame; rising, gaps are allowed
  std::vector<Eigen::Vector3d> points_m;
};

/// T_first_frame of each frame, in the order of the frames; that of the first is the identity.
using FramePoses = std::vector<Pose3>;

}  // namespace honka
