#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "algo/types/pose.h"

namespace honka::eval {

/// A true and an estimated pose of one moment, T_world_body each, their worlds not yet aligned.
struct PosePair {
  double time_s = 0.0;  ///< of the estimate
  Pose3 truth = Pose3::Identity(), estimate = Pose3::Identity();
};

/// Pairs with increasing times. Where a side knows positions alone, its rotations are never read.
struct PosePairs {
  std::vector<PosePair> poses;
  bool truth_has_rotations = true, estimate_has_rotations = true;
  /// Of all estimated poses, those without a true one among them; empty: all have one.
  std::vector<double> estimate_times_s;

  [[nodiscard]] bool have_rotations() const {
    return truth_has_rotations && estimate_has_rotations;
  }
};

/// Index of a true and of an estimated time that belong together.
struct TimePair {
  std::size_t truth = 0, estimate = 0;

  bool operator==(const TimePair&) const = default;
};

/// Pairs each time of the shorter list (the estimate, where both are equally long) with the
/// nearest of the longer one (the earlier of two equally near), where they differ by at most
/// `max_difference_s`. One to one: of two claims to a time the nearer wins, the earlier of equals.
/// Both lists strictly increase. In order of time.
[[nodiscard]] std::vector<TimePair> associate_times(std::span<const double> truth_s,
                                                    std::span<const double> estimate_s,
                                                    double max_difference_s);

/// Index of the time nearest to `time_s`, the earlier of two equally near; `times_s` strictly
/// increases and is not empty.
[[nodiscard]] std::size_t nearest_time(std::span<const double> times_s, double time_s);

}  // namespace honka::eval
