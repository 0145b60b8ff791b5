#include "eval/run/check/tolerance.h"

#include <algorithm>
#include <cmath>

#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

constexpr double kNormal95 = 1.96;  ///< s.d. of a normal that hold 95 % on both sides
constexpr double kOfExtremes = 0.25, kOfCounts = 0.05, kOfOthers = 0.10;
/// Sums in another order, relative and, near 0, absolute.
constexpr double kRounding = 1e-6, kSmallest = 1e-9;

bool has(std::string_view name, std::string_view part) {
  return name.find(part) != std::string_view::npos;
}

bool is_rate(std::string_view column, double value) {
  return value >= 0.0 && value <= 1.0 &&
         (has(column, "rate") || has(column, "share") || has(column, "success_"));
}

bool is_extreme(std::string_view column) {
  return has(column, "max") || has(column, "min") || has(column, "greatest") ||
         has(column, "std") || has(column, "p95");
}

double longer_side(double value, double low, double high) {
  return std::max(value - low, high - value);
}

/// Longer side of the interval of a share of `trials`.
std::optional<double> wilson_side(double share, double trials) {
  const auto n = std::llround(trials);
  const auto interval = wilson_interval(std::llround(share * trials), n);
  if (!interval) return std::nullopt;
  return longer_side(share, interval->low, interval->high);
}

double chance(std::string_view column, double value, const FigureSpread& spread) {
  if (spread.interval) return longer_side(value, (*spread.interval)[0], (*spread.interval)[1]);
  const double n = spread.trials.value_or(0.0);
  if (n >= 1.0 && is_rate(column, value) && !spread.is_count) {
    if (const auto side = wilson_side(value, n)) return *side;
  }
  if (n >= 1.0 && spread.is_count && value >= 0.0 && value < n) {
    if (const auto side = wilson_side(value / n, n)) return std::max(1.0, n * *side);
  }
  const double successes = n * spread.success_rate.value_or(1.0);
  if (spread.standard_deviation && successes >= 2.0) {
    return kNormal95 * *spread.standard_deviation / std::sqrt(successes);
  }
  if (spread.is_count) return std::max(1.0, kOfCounts * std::abs(value));
  return (is_extreme(column) ? kOfExtremes : kOfOthers) * std::abs(value);
}

}  // namespace

double tolerance_of(std::string_view column, double value, const FigureSpread& spread) {
  return std::max({chance(column, value, spread), kRounding * std::abs(value), kSmallest});
}

}  // namespace honka::eval
