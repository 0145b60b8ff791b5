#include "eval/metrics/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka::eval {
namespace {

constexpr double kNormal975 = 1.959963984540054;  // 97.5 % point of the standard normal

double sum_of_squares(std::span<const double> values) {
  double sum = 0.0;
  for (const double v : values) sum += v * v;
  return sum;
}

}  // namespace

std::optional<double> mean(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> standard_deviation(std::span<const double> values) {
  if (values.size() < 2) return std::nullopt;
  const double centre = *mean(values);
  double sum = 0.0;
  for (const double v : values) sum += (v - centre) * (v - centre);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

std::optional<double> median(std::span<const double> values) { return percentile(values, 50.0); }

std::optional<double> percentile(std::span<const double> values, double percent) {
  HONKA_CHECK(percent >= 0.0 && percent <= 100.0, "a percentile lies in [0, 100]");
  if (values.empty()) return std::nullopt;
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const double place = percent / 100.0 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

std::optional<double> minimum(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return *std::min_element(values.begin(), values.end());
}

std::optional<double> maximum(std::span<const double> values) {
  if (values.empty()) return std::nullopt;
  return *std::max_element(values.begin(), values.end());
}

std::optional<double> rmse(std::span<const double> errors) {
  if (errors.empty()) return std::nullopt;
  return std::sqrt(sum_of_squares(errors) / static_cast<double>(errors.size()));
}

std::optional<double> pooled_rmse(std::span<const std::vector<double>> trials) {
  double sum = 0.0, count = 0.0;
  for (const std::vector<double>& errors : trials) {
    sum += sum_of_squares(errors);
    count += static_cast<double>(errors.size());
  }
  if (count == 0.0) return std::nullopt;
  return std::sqrt(sum / count);
}

std::optional<Interval> wilson_interval(std::int64_t successes, std::int64_t trials) {
  HONKA_CHECK(successes >= 0 && successes <= trials, "more successes than trials");
  if (trials == 0) return std::nullopt;
  return score_interval(static_cast<double>(successes) / static_cast<double>(trials),
                        static_cast<double>(trials));
}

Interval score_interval(double rate, double n) {
  HONKA_CHECK(rate >= 0.0 && rate <= 1.0 && n > 0.0, "a rate lies in [0, 1]");
  const double z2 = kNormal975 * kNormal975;
  const double centre = (rate + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half =
      kNormal975 * std::sqrt(rate * (1.0 - rate) / n + z2 / (4.0 * n * n)) / (1.0 + z2 / n);
  return {rate == 0.0 ? 0.0 : centre - half, rate == 1.0 ? 1.0 : centre + half};
}

std::optional<Interval> bootstrap_ratio(std::span<const Block> blocks,
                                        const BootstrapSettings& settings) {
  HONKA_CHECK(settings.resamples > 0, "a bootstrap needs resamples");
  std::vector<Block> counted;
  for (const Block& block : blocks) {
    if (block.count > 0.0) counted.push_back(block);
  }
  if (counted.size() < 2) return std::nullopt;
  RandomStream random(settings.seed, settings.name);
  std::vector<double> ratios;
  ratios.reserve(static_cast<std::size_t>(settings.resamples));
  for (int k = 0; k < settings.resamples; ++k) {
    Block total;
    for (std::size_t i = 0; i < counted.size(); ++i) {
      const Block& drawn = counted[random.below(counted.size())];
      total.sum += drawn.sum;
      total.count += drawn.count;
    }
    ratios.push_back(total.sum / total.count);
  }
  return Interval{*percentile(ratios, 2.5), *percentile(ratios, 97.5)};
}

std::optional<Interval> bootstrap_mean(std::span<const double> values,
                                       const BootstrapSettings& settings) {
  std::vector<Block> blocks;
  for (const double v : values) blocks.push_back({v, 1.0});
  return bootstrap_ratio(blocks, settings);
}

std::optional<PairedDifference> paired_difference(std::span<const double> a,
                                                  std::span<const double> b,
                                                  const BootstrapSettings& settings) {
  HONKA_CHECK(a.size() == b.size(), "paired values come in pairs");
  if (a.empty()) return std::nullopt;
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
  return PairedDifference{*mean(differences), standard_deviation(differences),
                          bootstrap_mean(differences, settings),
                          static_cast<std::int64_t>(a.size())};
}

}  // namespace honka::eval
