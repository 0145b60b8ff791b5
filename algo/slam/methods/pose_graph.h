#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/methods/pair_match.h"
#include "algo/slam/sparse_frame.h"
#include "algo/types/settings.h"

namespace honka {

/// What a measured motion between two frames weighs, and how the graph is solved.
struct PoseGraphSettings {
  double chain_m = 0.05;  ///< standard deviations of a step of the chain
  double chain_deg = 0.3;
  double match_m = 0.03;  ///< and of a corrective match
  double match_deg = 0.12;
  double bad_step_factor = 20.0;  ///< on those of a step that failed its test
  double robust_scale = 3.0;      ///< Cauchy loss of matches, in standard deviations; 0: none
  std::int64_t max_iterations = 30;
};
void describe(SettingsVisitor& v, PoseGraphSettings& s);

/// A measured motion between two frames.
struct PoseGraphEdge {
  std::size_t target = 0, source = 0;  ///< positions in the list of poses
  Pose3 T_target_source = Pose3::Identity();
  double sigma_m = 1.0, sigma_rad = 1.0;
  bool robust = false;
};

/// How a graph was solved. The poses are finite whatever happened.
struct PoseGraphResult {
  FramePoses T_first_frame;
  bool converged = false;
  int iterations = 0;
  double initial_cost = 0.0, final_cost = 0.0;  ///< half the robust sum of squares
};

/// Edges between neighbours with the motions that `T_first_frame` holds; `bad_steps` (may be empty)
/// marks those that count little.
[[nodiscard]] std::vector<PoseGraphEdge> chain_edges(const FramePoses& T_first_frame,
                                                     std::span<const std::uint8_t> bad_steps,
                                                     const PoseGraphSettings& settings);

/// Edges of corrective matches, with the robust loss.
[[nodiscard]] std::vector<PoseGraphEdge> match_edges(std::span<const PairMatch> matches,
                                                     const PoseGraphSettings& settings);

/// The poses that fit all edges best in least squares, the first held still (Ceres, one thread,
/// sparse Cholesky). An edge that is not finite, or names a pose that is not there, is left out.
/// Source: choice, beyond Nevalainen2021.
[[nodiscard]] PoseGraphResult optimize_pose_graph(const FramePoses& start,
                                                  std::span<const PoseGraphEdge> edges,
                                                  const PoseGraphSettings& settings);

}  // namespace honka
