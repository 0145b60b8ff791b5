#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/trajectory_drift.h"
#include "eval/metrics/trajectory_errors.h"
#include "eval/run/odometry_trial.h"

namespace honka::eval {

/// When an odometry counts as lost.
struct LostLimits {
  double predicted_s = 1.0;  ///< a longer run of sweeps without registration
  double span_s = 1.0;       ///< or where the motion over this time
  double translation_m = 1.0;
  double rotation_deg = 5.0;  ///< is wrong by more than either
};

/// A time over which an odometry was lost.
struct LostSequence {
  double start_s = 0.0, end_s = 0.0;
  std::string cause;  ///< the most frequent of its sweeps; "unnoticed" where none gave one
};

/// Every greatest run of sweeps that lie in an unregistered stretch or in a wrong motion.
[[nodiscard]] std::vector<LostSequence> lost_sequences(const OdometryRun& run,
                                                       const LostLimits& limits = {});

/// The figures of one odometry on one stand, over one trial or several.
struct OdometryScores {
  std::string stand, odometry;
  std::int64_t trials = 0;
  double driven_m = 0.0, sensor_s = 0.0, cpu_s = 0.0;
  std::vector<SubPathError> sub_paths;
  TrajectoryErrors rpe_per_metre;              ///< end to end, by the estimate's path
  TrajectoryErrors ape;                        ///< after yaw + translation
  std::array<std::int64_t, 4> statuses{};      ///< sweeps by OdometryStatus
  std::map<std::string, std::int64_t> causes;  ///< sweeps by cause, none left out
  std::vector<LostSequence> lost;
  std::vector<double> times_ms;

  [[nodiscard]] std::int64_t sweeps(OdometryStatus status) const {
    return statuses.at(static_cast<std::size_t>(status));
  }
  /// Sensor seconds a second of processor time.
  [[nodiscard]] double real_time_factor() const { return cpu_s > 0.0 ? sensor_s / cpu_s : 0.0; }
  /// Adds those of another trial.
  void merge(const OdometryScores& other);
};

[[nodiscard]] OdometryScores score_odometry(const OdometryRun& run);

/// The errors of a run after yaw + translation; after making the first poses equal where it never
/// left its place.
[[nodiscard]] PosePairs aligned_by_yaw(const PosePairs& pairs);

}  // namespace honka::eval
