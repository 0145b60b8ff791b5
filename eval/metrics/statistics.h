#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace honka::eval {

// Every statistic of too few values is nothing, never 0. Values must be finite.

[[nodiscard]] std::optional<double> mean(std::span<const double> values);
/// Sample standard deviation, n − 1 below the root; nothing for fewer than two values.
[[nodiscard]] std::optional<double> standard_deviation(std::span<const double> values);
[[nodiscard]] std::optional<double> median(std::span<const double> values);
/// Linear between order statistics (Hyndman & Fan 1996, type 7, as numpy); `percent` in [0, 100].
[[nodiscard]] std::optional<double> percentile(std::span<const double> values, double percent);
[[nodiscard]] std::optional<double> minimum(std::span<const double> values);
[[nodiscard]] std::optional<double> maximum(std::span<const double> values);
/// √(Σ v² / n) of errors.
[[nodiscard]] std::optional<double> rmse(std::span<const double> errors);
/// The RMSE over all errors of all trials together; never the mean of their RMSEs.
[[nodiscard]] std::optional<double> pooled_rmse(std::span<const std::vector<double>> trials);

struct Interval {
  double low = 0.0, high = 0.0;
};

/// Wilson's score interval of a rate, 95 %: for trials that are independent (disjoint windows).
[[nodiscard]] std::optional<Interval> wilson_interval(std::int64_t successes, std::int64_t trials);

/// The same for a rate over n trials' worth of knowledge, n > 0 not always whole.
[[nodiscard]] Interval score_interval(double rate, double n);

/// What one block (a stand, 20 m of road) adds to a ratio: errors and their number, or successes
/// and trials.
struct Block {
  double sum = 0.0;
  double count = 0.0;
};

struct BootstrapSettings {
  std::uint64_t seed = 1;
  std::string_view name = "bootstrap";  ///< of the random stream
  int resamples = 2000;
};

/// Percentile bootstrap, 95 %, of Σ sum / Σ count over blocks drawn with replacement: for rates and
/// means whose trials within a block depend on each other. Nothing for fewer than two blocks with
/// a count. The same digits for the same seed and name.
[[nodiscard]] std::optional<Interval> bootstrap_ratio(std::span<const Block> blocks,
                                                      const BootstrapSettings& settings = {});
/// The same of the mean of independent values.
[[nodiscard]] std::optional<Interval> bootstrap_mean(std::span<const double> values,
                                                     const BootstrapSettings& settings = {});

/// a − b, trial by trial on common seeds.
struct PairedDifference {
  double mean = 0.0;
  std::optional<double> standard_deviation;
  std::optional<Interval> interval;  ///< bootstrap of the mean, 95 %
  std::int64_t n = 0;
};

/// Nothing for no pairs. Ends the program when the lengths differ.
[[nodiscard]] std::optional<PairedDifference> paired_difference(
    std::span<const double> a, std::span<const double> b, const BootstrapSettings& settings = {});

}  // namespace honka::eval
