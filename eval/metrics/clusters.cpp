#include "eval/metrics/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "algo/types/check.h"

namespace honka::eval {
namespace {

constexpr double kNormalPoint = 1.959963984540054;  // 97.5 % of the standard normal

std::vector<Block> sums_by_cluster(std::span<const double> values,
                                   std::span<const std::int64_t> cluster_of) {
  std::vector<Block> sums;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto cluster = static_cast<std::size_t>(cluster_of[i]);
    if (cluster >= sums.size()) sums.resize(cluster + 1);
    sums[cluster].sum += values[i];
    sums[cluster].count += 1.0;
  }
  return sums;
}

}  // namespace

ClusterSpread cluster_spread(std::span<const double> values,
                             std::span<const std::int64_t> cluster_of) {
  HONKA_CHECK(values.size() == cluster_of.size(), "every value has its cluster");
  const std::vector<Block> sums = sums_by_cluster(values, cluster_of);
  ClusterSpread spread;
  spread.clusters =
      std::count_if(sums.begin(), sums.end(), [](const Block& b) { return b.count > 0.0; });
  const auto size = static_cast<std::int64_t>(values.size());
  if (spread.clusters < 2 || spread.clusters == size) return spread;
  const double n = static_cast<double>(size), middle = *mean(values);
  double within = 0.0, between = 0.0;
  for (const double value : values) within += (value - middle) * (value - middle);
  for (const Block& s : sums) between += std::pow(s.sum - middle * s.count, 2);
  if (within <= 0.0) return spread;
  const double w = static_cast<double>(spread.clusters);
  spread.design_effect = w / (w - 1.0) * between / (n * n) / (within / (n * (n - 1.0)));
  if (spread.design_effect > 1.0) {
    spread.widening =
        std::sqrt(spread.design_effect) * student_975(spread.clusters - 1) / kNormalPoint;
  }
  return spread;
}

double student_975(std::int64_t degrees_of_freedom) {
  HONKA_CHECK(degrees_of_freedom > 0, "Student's law has degrees of freedom");
  constexpr std::array<double, 9> kFew = {12.706204736432095, 4.302652729911275, 3.182446305284263,
                                          2.7764451051977987, 2.570581835636197, 2.446911848791681,
                                          2.3646242510102993, 2.306004135033371, 2.262157162740992};
  if (degrees_of_freedom <= 9) return kFew[static_cast<std::size_t>(degrees_of_freedom - 1)];
  // Abramowitz & Stegun 1964, 26.7.5: to 2e-6 from 10 degrees of freedom on.
  const double z = kNormalPoint, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z, z9 = z7 * z * z;
  const double v = static_cast<double>(degrees_of_freedom);
  return z + (z3 + z) / (4.0 * v) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * v * v) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * v * v * v) +
         (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z) /
             (92160.0 * v * v * v * v);
}

std::optional<Interval> clustered_rate_interval(std::int64_t successes, std::int64_t trials,
                                                double widening) {
  HONKA_CHECK(widening >= 1.0, "an interval is only made wider");
  if (widening == 1.0) return wilson_interval(successes, trials);
  if (trials == 0) return std::nullopt;
  return score_interval(static_cast<double>(successes) / static_cast<double>(trials),
                        static_cast<double>(trials) / (widening * widening));
}

Interval widened(const Interval& interval, double middle, double widening, double least) {
  return {std::max(least, middle - widening * (middle - interval.low)),
          std::max(least, middle + widening * (interval.high - middle))};
}

}  // namespace honka::eval
