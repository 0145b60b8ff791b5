#pragma once

#include <cstdint>
#include <vector>

#include "algo/slam/methods/pair_match.h"
#include "algo/slam/sparse_frame.h"

namespace honka::test {

/// A stand without noise and a bent drive through it: every answer is known exactly.
struct MethodsWorld {
  std::vector<Eigen::Vector3d> stems_in_first_m;
  FramePoses T_first_frame;  ///< truth; the first is the identity
  std::vector<SparseFrame> frames;
};

/// Stems on a jittered lattice of 3.3 m over hills; `frames` key frames 0.5 m apart on a bent track
/// with roll and pitch, each seeing the stems within 25 m. Planar noise as told, in metres.
[[nodiscard]] MethodsWorld methods_world(std::size_t frames, double noise_m = 0.0);

/// The same track as a chain that drifts: each step off by a little turn and shift.
[[nodiscard]] FramePoses bent_chain(const FramePoses& T_first_frame, double turn_rad,
                                    double shift_m);

/// True matches of frames `gap` apart, every half gap.
[[nodiscard]] std::vector<PairMatch> true_matches(const FramePoses& T_first_frame, std::size_t gap);

/// RMS of the distances of positions once the estimate is laid onto the truth rigidly.
[[nodiscard]] double aligned_error_m(const FramePoses& estimate, const FramePoses& truth);

/// Largest entry by which two lists of poses differ.
[[nodiscard]] double largest_difference(const FramePoses& a, const FramePoses& b);

[[nodiscard]] bool all_poses_finite(const FramePoses& poses);

}  // namespace honka::test
