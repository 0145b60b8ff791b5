#include "eval/metrics/paired_rates.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka::eval {
namespace {

/// Correlation of the two outcomes, brought towards 0 for few trials (Newcombe 1998, method 10).
double paired_correlation(double both, double first, double second, double none) {
  const double product = (both + first) * (second + none) * (both + second) * (first + none);
  if (product <= 0.0) return 0.0;
  double excess = both * none - first * second;
  if (excess > 0.0) excess = std::max(0.0, excess - 0.5 * (both + first + second + none));
  return excess / std::sqrt(product);
}

double root_of(double a, double b, double correlation) {
  return std::sqrt(std::max(0.0, a * a - 2.0 * correlation * a * b + b * b));
}

}  // namespace

std::optional<Interval> paired_rate_interval(const PairedCounts& counts, double widening) {
  HONKA_CHECK(widening >= 1.0, "an interval is only made wider");
  if (counts.trials() == 0) return std::nullopt;
  const double scale = 1.0 / (widening * widening);
  const double both = scale * static_cast<double>(counts.both);
  const double first = scale * static_cast<double>(counts.first_only);
  const double second = scale * static_cast<double>(counts.second_only);
  const double none = scale * static_cast<double>(counts.none);
  const double n = both + first + second + none;
  const double p1 = (both + first) / n, p2 = (both + second) / n;
  const Interval one = score_interval(p1, n), two = score_interval(p2, n);
  const double correlation = paired_correlation(both, first, second, none);
  return Interval{p1 - p2 - root_of(p1 - one.low, two.high - p2, correlation),
                  p1 - p2 + root_of(one.high - p1, p2 - two.low, correlation)};
}

double mcnemar_exact(const PairedCounts& counts) {
  const std::int64_t differ = counts.first_only + counts.second_only;
  const std::int64_t fewer = std::min(counts.first_only, counts.second_only);
  if (differ == 0) return 1.0;
  const double n = static_cast<double>(differ);
  // Binomial terms, each from the one before: log C(n, k) − n log 2.
  double log_term = -n * std::log(2.0), sum = 0.0;
  for (std::int64_t k = 0; k <= fewer; ++k) {
    sum += std::exp(log_term);
    log_term += std::log((n - static_cast<double>(k)) / static_cast<double>(k + 1));
  }
  return std::min(1.0, 2.0 * sum);
}

}  // namespace honka::eval
