#pragma once

#include <limits>
#include <span>
#include <vector>

#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/clusters.h"
#include "eval/metrics/trajectory_pairs.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// The figures of a map that poses make of a drive's frames; NaN where there is none.
struct SlamQuality {
  double blur = std::numeric_limits<double>::quiet_NaN();  ///< β, Eq. 30
  double box_dimension = std::numeric_limits<double>::quiet_NaN();
  double cluster_rmse_m = std::numeric_limits<double>::quiet_NaN();     ///< e_C, link 1.0, mean
  double cluster_rmse_05_m = std::numeric_limits<double>::quiet_NaN();  ///< link 0.5, mean
  double pooled_rmse_m = std::numeric_limits<double>::quiet_NaN();      ///< link 1.0, pooled
  double pooled_rmse_05_m = std::numeric_limits<double>::quiet_NaN();   ///< link 0.5, pooled
  double ate_m = std::numeric_limits<double>::quiet_NaN();  ///< RMSE of positions, laid on rigidly
  double ate_planar_m = std::numeric_limits<double>::quiet_NaN();  ///< of it x and y of truth
  double ate_deg = std::numeric_limits<double>::quiet_NaN();       ///< RMSE of rotations, likewise
};

/// Judges poses T_first_frame of all frames of a drive. With the true poses it is the floor: what
/// the noise of the stems alone leaves.
[[nodiscard]] SlamQuality judge_slam(const SlamDrive& drive, const FramePoses& T_first_frame,
                                     const BlurSettings& blur_settings);

/// The poses laid onto the true ones: rigidly; by yaw and translation where the way is straight;
/// as they are where the machine never moved.
[[nodiscard]] PosePairs laid_on_truth(const SlamDrive& drive, const FramePoses& T_first_frame);

}  // namespace honka::eval
