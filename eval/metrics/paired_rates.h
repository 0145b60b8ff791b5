#pragma once

#include <cstdint>
#include <optional>

#include "eval/metrics/statistics.h"

namespace honka::eval {

/// Two methods on the same trials: how often both, one or none succeeded.
struct PairedCounts {
  std::int64_t both = 0, first_only = 0, second_only = 0, none = 0;

  [[nodiscard]] std::int64_t trials() const { return both + first_only + second_only + none; }
};

/// Interval of (rate of the first − rate of the second), 95 %: square and add of Wilson's, with the
/// correlation of the pairs (Newcombe 1998, Statistics in Medicine 17:2635, method 10). The trials
/// say as much as trials / widening² independent ones. Nothing for no trials.
[[nodiscard]] std::optional<Interval> paired_rate_interval(const PairedCounts& counts,
                                                           double widening = 1.0);

/// McNemar's exact two-sided probability that trials on which the methods differ would fall as
/// unevenly by chance; 1 where they never differ. For independent trials.
[[nodiscard]] double mcnemar_exact(const PairedCounts& counts);

}  // namespace honka::eval
