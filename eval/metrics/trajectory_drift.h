#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "eval/metrics/trajectory_pairs.h"

namespace honka::eval {

/// Over which parts of a drive its drift is taken.
struct DriftSettings {
  std::vector<double> lengths_m = {10.0, 20.0, 50.0, 100.0};
  double step_m = 1.0;  ///< driven between the starts of two sub-paths
};

/// Error of the estimated motion over a sub-path.
struct SubPathError {
  double length_m = 0.0;  ///< driven
  double start_s = 0.0;
  double translation_m = 0.0, rotation_deg = 0.0;
};

/// Errors (Q_i⁻¹ Q_j)⁻¹ (P_i⁻¹ P_j) of all sub-paths, length by length (Geiger et al. 2012, KITTI).
///
/// `driven_m[i]`: the way that the machine has driven at pair i, never falling. A sub-path of
/// length L starts at the first pose at or after each whole `step_m` of way, and ends at the first
/// pose that has driven L more; those that the drive cuts off are left out. Both sides must know
/// rotations.
[[nodiscard]] std::vector<SubPathError> sub_path_errors(const PosePairs& pairs,
                                                        std::span<const double> driven_m,
                                                        const DriftSettings& settings = {});

/// Mean over sub-paths of error / length.
struct Drift {
  double percent = 0.0;    ///< of the way driven
  double deg_per_m = 0.0;  ///< rotation by the way driven
  std::int64_t sub_paths = 0;
};

/// Over the sub-paths of one length, or over all. Nothing of none.
[[nodiscard]] std::optional<Drift> mean_drift(std::span<const SubPathError> errors,
                                              std::optional<double> length_m = {});

}  // namespace honka::eval
