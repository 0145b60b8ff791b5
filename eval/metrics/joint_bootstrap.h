#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "eval/metrics/statistics.h"

namespace honka::eval {

/// How often each of n rows is in each resample: the costly part of a bootstrap, made once for all
/// samples of the same size.
class BootstrapDraws {
 public:
  BootstrapDraws(std::size_t rows, const BootstrapSettings& settings);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t resamples() const {
    return times_.size() / std::max<std::size_t>(rows_, 1);
  }
  /// Of each row, in one resample.
  [[nodiscard]] std::span<const std::uint16_t> times(std::size_t resample) const {
    return std::span<const std::uint16_t>(times_).subspan(resample * rows_, rows_);
  }

 private:
  std::size_t rows_;
  std::vector<std::uint16_t> times_;  ///< resample after resample
};

/// Percentile bootstrap, 95 %, of statistics of the same trials: one set of draws for all of them,
/// so that differences between methods are taken draw by draw.
///
/// A trial is a row of so many columns; what a statistic sees is the sum of each column over a
/// draw. Above kDrawnRows trials, runs of consecutive ones are drawn together: as they do not
/// depend on each other, the spread is the same, and the cost no longer grows with their number.
class JointBootstrap {
 public:
  static constexpr std::size_t kDrawnRows = 400;  ///< s.d. of an interval's width: 1/√800 = 3.5 %

  /// Rows that are drawn of so many trials.
  [[nodiscard]] static std::size_t drawn_rows(std::size_t trials) {
    return std::min(trials, kDrawnRows);
  }

  /// `rows`: row after row of `columns` finite numbers; `draws` of drawn_rows() of them.
  JointBootstrap(std::span<const double> rows, std::size_t columns, const BootstrapDraws& draws);

  /// Interval of statistic(sums); nothing for fewer than two rows. Draws for which it is not finite
  /// (no success in them) are left out, and where these are most of them there is nothing.
  template <class Statistic>
  [[nodiscard]] std::optional<Interval> interval(const Statistic& statistic) const {
    std::vector<double> values;
    values.reserve(resamples_);
    for (std::size_t k = 0; k < resamples_; ++k) {
      const double value =
          statistic(std::span<const double>(sums_).subspan(k * columns_, columns_));
      if (std::isfinite(value)) values.push_back(value);
    }
    return percentiles_of(std::move(values));
  }

 private:
  [[nodiscard]] std::optional<Interval> percentiles_of(std::vector<double> values) const;

  std::size_t columns_, resamples_ = 0;
  std::vector<double> sums_;  ///< resample after resample
};

}  // namespace honka::eval
