#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/registration/trimmed_icp.h"
#include "algo/slam/sparse_frame.h"

namespace honka {

/// How the chain of key frames is made, and what it does where two frames cannot be registered.
struct ChainSettings {
  double inlier_ratio = 0.95;  ///< of the trimmed ICP between neighbours
  std::int64_t max_iterations = 30;
  double tolerance_m = 0.01;
  double tolerance_deg = 0.5;
  std::string guess = "identity";                 ///< identity | constant_velocity
  std::string failed_step = "constant_velocity";  ///< identity | constant_velocity
};
void describe(SettingsVisitor& v, ChainSettings& s);

/// The chain: all poses finite, and how each step came about.
struct Chain {
  FramePoses T_first_frame;         ///< as many as frames
  std::vector<Registration> steps;  ///< of frame l + 1 onto frame l; one less than frames

  [[nodiscard]] int failed_steps() const;
};

/// Registers each frame onto the one before it, by trimmed ICP from the guess, and composes the
/// steps. A step that cannot be registered goes on as `failed_step` says: its pose is that motion
/// and its status says why. No frames give an empty chain.
/// Source: Nevalainen2021 Eq. (16), t_l+1,1 = t_l1 t_l+1,l.
[[nodiscard]] Chain make_chain(std::span<const SparseFrame> frames, const ChainSettings& settings);

/// T_j_i of two frames of a map. Source: Nevalainen2021 Eq. (17).
[[nodiscard]] Pose3 between(const FramePoses& T_first_frame, std::size_t j, std::size_t i);

/// The path: where the scanner was, in the first frame. Source: Nevalainen2021 Eq. (18).
[[nodiscard]] std::vector<Eigen::Vector3d> path_of(const FramePoses& T_first_frame);

/// All points of all frames in the first frame, frame by frame; as many poses as frames.
/// Source: Nevalainen2021 Eq. (16).
[[nodiscard]] std::vector<Eigen::Vector3d> map_points(std::span<const SparseFrame> frames,
                                                      const FramePoses& T_first_frame);

}  // namespace honka
