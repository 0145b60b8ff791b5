#pragma once

#include <cstdint>

#include "algo/slam/view_cone.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// How the stems of a drive's key frames stand to the true ones. Sums, so that drives add up.
struct FrameScores {
  std::int64_t frames = 0;
  std::int64_t found = 0;          ///< stems in frames
  std::int64_t found_matched = 0;  ///< of them with a true stem within the gate
  std::int64_t truth = 0;          ///< true stems in the view cones, hidden ones too
  std::int64_t truth_matched = 0;  ///< of them found
  double planar_m2 = 0.0;          ///< Σ of the squared horizontal error of the matched
  double height_m2 = 0.0;          ///< Σ of their squared error in height
  double radial_m = 0.0;           ///< Σ of their error along the ray; negative: to the sensor

  void add(const FrameScores& other);
};

/// Every key frame against the true stems, seen from its true pose; in the frame's own axes.
[[nodiscard]] FrameScores score_frames(const SlamDrive& drive, const ViewCone& cone, double gate_m);

}  // namespace honka::eval
