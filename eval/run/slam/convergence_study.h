#pragma once

#include <cstdint>
#include <vector>

#include "algo/slam/registration/trimmed_icp.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// Two key frames that see much of the same, and where the second truly is in the first.
struct ConvergencePair {
  std::size_t target = 0, source = 0;  ///< places in the drive
  Pose3 T_target_source = Pose3::Identity();
  double overlap = 0.0;  ///< λ
  NearestStems stems;    ///< of the target
};

/// Draws pairs from a drive: at least 1 m apart, λ at least 0.4, twenty stems each. Fewer than
/// asked for where the drive does not hold them.
[[nodiscard]] std::vector<ConvergencePair> draw_convergence_pairs(const SlamDrive& drive,
                                                                  std::size_t count,
                                                                  std::uint64_t seed);

/// By how much a start is off.
struct StartError {
  double shift_m = 0.0, turn_deg = 0.0, tilt_deg = 0.0;
};

/// What ICP made of starts that were off by so much, over all pairs and directions.
struct ConvergencePoint {
  StartError start;
  double error_m = 0.0;  ///< e: RMSE over the best 40 % of the distances, mean over the starts
  double success = 0.0;  ///< part of the starts that end within 0.5 m and 2° of the truth
  std::int64_t starts = 0;
};

/// Starts each pair from four directions a quarter turn apart, the turn to both sides by turns.
/// The digits do not depend on the threads.
[[nodiscard]] std::vector<ConvergencePoint> study_convergence(
    const SlamDrive& drive, const std::vector<ConvergencePair>& pairs,
    const std::vector<StartError>& starts, std::uint64_t seed, int threads);

/// Start errors along the quarter ellipse with these half axes, from the one to the other.
[[nodiscard]] std::vector<StartError> starts_on_ellipse(double shift_m, double turn_deg);

/// L0 of a mean frame, rim left out (Eq. 23).
[[nodiscard]] double mean_frame_l0_m(const SlamDrive& drive);

}  // namespace honka::eval
