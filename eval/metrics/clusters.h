#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "eval/metrics/statistics.h"

namespace honka::eval {

/// How much less trials say that share something (a forest) than as many independent ones.
struct ClusterSpread {
  std::int64_t clusters = 0;  ///< that hold any value
  /// Variance of the mean between clusters over that of independent values; 1 where no value shares
  /// its cluster, where there is one cluster alone, or where all values are equal.
  double design_effect = 1.0;
  /// What the width of an interval for independent values is to be multiplied with, ≥ 1.
  double widening = 1.0;
};

/// Of the mean of the values; `cluster_of[i]` ≥ 0 is the cluster of values[i]. With W clusters of
/// sums s and sizes m, mean x̄ and n values the design effect is
/// W/(W − 1) Σ (s − x̄ m)² / n² over Σ (x − x̄)² / (n(n − 1)) (Kish 1965, ratio estimator). Above 1
/// the widening is its root times t(W − 1)/z: the spread is known from W clusters alone. At or
/// below 1 nothing is made narrower.
[[nodiscard]] ClusterSpread cluster_spread(std::span<const double> values,
                                           std::span<const std::int64_t> cluster_of);

/// 97.5 % point of Student's law.
[[nodiscard]] double student_975(std::int64_t degrees_of_freedom);

/// Wilson's score interval, 95 %, of a rate over n trials that say as much as n / widening²
/// independent ones (Dean & Pagano 2015). Nothing for n = 0.
[[nodiscard]] std::optional<Interval> clustered_rate_interval(std::int64_t successes,
                                                              std::int64_t trials, double widening);

/// An interval about `middle` made wider on both sides; its ends stay at or above `least`.
[[nodiscard]] Interval widened(const Interval& interval, double middle, double widening,
                               double least);

}  // namespace honka::eval
