#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "eval/metrics/trajectory_pairs.h"

namespace honka::eval {

/// Of errors ≥ 0. Here `std` has n below the root, as in the tools that these figures are compared
/// with (numpy's default), so that rmse² = mean² + std².
struct TrajectoryStatistics {
  double rmse = 0.0, mean = 0.0, median = 0.0, std = 0.0, min = 0.0, max = 0.0;
  double sse = 0.0;  ///< sum of squares
};

/// Nothing of no values.
[[nodiscard]] std::optional<TrajectoryStatistics> trajectory_statistics(
    std::span<const double> errors);

/// One error a pair; `rotation_deg` is empty where a side has no rotations.
struct TrajectoryErrors {
  std::vector<double> translation_m, rotation_deg;
};

/// Absolute pose error: |t| and the angle of truth⁻¹ · estimate, pair by pair (Sturm et al. 2012,
/// Eq. (3)). Align before.
[[nodiscard]] TrajectoryErrors absolute_errors(const PosePairs& pairs);

enum class DeltaUnit { kSeconds, kMetres, kFrames };

/// Over which motions the relative error is taken.
struct RelativeSettings {
  double delta = 1.0;  ///< > 0, in the unit; frames: a whole number
  DeltaUnit unit = DeltaUnit::kSeconds;
  bool all_pairs = false;  ///< frames, metres: every pose begins a motion
};

/// A motion from one pose to a later one, by index.
struct Motion {
  std::size_t from = 0, to = 0;

  bool operator==(const Motion&) const = default;
};

/// The motions over delta, chosen by the estimate:
/// - seconds: from every pose to the estimated one nearest to `delta` later. Dropped are motions
///   to the last estimated pose or to one that has no true pose (Sturm's script), and those that
///   do not leave their pose;
/// - metres: consecutive stretches that end where the path since the last end has reached `delta`;
///   the first stretch only finds the first end (evo). All pairs: from every pose to the one whose
///   path from there is nearest to `delta`, where within a tenth of it;
/// - frames: 0 → n → 2n …; all pairs: i → i + n.
[[nodiscard]] std::vector<Motion> motions(const PosePairs& pairs, const RelativeSettings& settings);

/// Relative pose error: |t| and the angle of (Q_i⁻¹ Q_j)⁻¹ (P_i⁻¹ P_j) with the true motion Q, the
/// estimated P (Sturm et al. 2012, Eq. (1)). Where a side has no rotations the translation error is
/// the difference of the lengths of both displacements, which no alignment but a scale changes.
[[nodiscard]] TrajectoryErrors relative_errors(const PosePairs& pairs,
                                               std::span<const Motion> motions);

}  // namespace honka::eval
