#pragma once

#include <cmath>

#include "algo/geometry/se3.h"
#include "algo/types/random.h"
#include "eval/metrics/trajectory_alignment.h"

namespace honka::test {

/// A winding path in space at 10 Hz, estimated without error.
inline eval::PosePairs winding(std::size_t poses) {
  eval::PosePairs pairs;
  for (std::size_t i = 0; i < poses; ++i) {
    const double s = 0.1 * static_cast<double>(i);
    const Pose3 pose =
        pose_from_rpy({3.0 * s, 4.0 * std::sin(s), std::cos(0.7 * s)}, 0.1 * std::sin(3.0 * s),
                      0.05 * std::cos(s), 0.8 * std::cos(s));
    pairs.poses.push_back({s, pose, pose});
  }
  return pairs;
}

/// The same with noise on the estimates, from a stream of its own.
inline eval::PosePairs noisy(std::size_t poses, double sd_m, double sd_rad) {
  eval::PosePairs pairs = winding(poses);
  RandomStream random(7, "trajectory noise");
  for (eval::PosePair& pair : pairs.poses) {
    Twist twist;
    for (int k = 0; k < 6; ++k) twist[k] = random.normal(0.0, k < 3 ? sd_m : sd_rad);
    pair.estimate = pair.estimate * se3_exp(twist);
  }
  return pairs;
}

}  // namespace honka::test
