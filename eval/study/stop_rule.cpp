#include "eval/study/stop_rule.h"

#include <algorithm>

#include "algo/types/check.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

bool narrow_enough(std::int64_t successes, std::int64_t trials, double half_width) {
  const auto interval = wilson_interval(successes, trials);
  return interval && 0.5 * (interval->high - interval->low) <= half_width;
}

}  // namespace

std::optional<std::int64_t> stopped_after(const std::vector<std::vector<std::uint8_t>>& successes,
                                          double half_width) {
  if (successes.empty() || half_width <= 0.0) return std::nullopt;
  const std::size_t trials = successes.front().size();
  for (const auto& method : successes) {
    HONKA_CHECK(method.size() == trials, "every method has every trial");
  }
  std::vector<std::int64_t> counts(successes.size(), 0);
  for (std::size_t trial = 0; trial < trials; ++trial) {
    for (std::size_t m = 0; m < successes.size(); ++m) counts[m] += successes[m][trial] != 0;
    const auto n = static_cast<std::int64_t>(trial + 1);
    if (n % kStopLook != 0) continue;
    const bool all = std::all_of(counts.begin(), counts.end(), [&](std::int64_t count) {
      return narrow_enough(count, n, half_width);
    });
    if (all) return n;
  }
  return std::nullopt;
}

}  // namespace honka::eval
