#include "eval/metrics/joint_bootstrap.h"

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka::eval {
namespace {

/// Sums of runs of consecutive rows, at most so many runs.
std::vector<double> runs_of(std::span<const double> rows, std::size_t columns, std::size_t runs) {
  const std::size_t n = rows.size() / columns;
  std::vector<double> sums(runs * columns, 0.0);
  for (std::size_t row = 0; row < n; ++row) {
    double* sum = &sums[row * runs / n * columns];
    for (std::size_t c = 0; c < columns; ++c) sum[c] += rows[row * columns + c];
  }
  return sums;
}

}  // namespace

BootstrapDraws::BootstrapDraws(std::size_t rows, const BootstrapSettings& settings) : rows_(rows) {
  HONKA_CHECK(settings.resamples > 0, "a bootstrap needs resamples");
  HONKA_CHECK(rows < 1U << 16U, "a row is drawn at most as often as there are rows");
  const auto resamples = static_cast<std::size_t>(settings.resamples);
  times_.assign(resamples * rows, 0);
  RandomStream random(settings.seed, settings.name, {rows});
  for (std::size_t k = 0; k < resamples; ++k) {
    for (std::size_t i = 0; i < rows; ++i) {
      // Multiply and shift; the bias is below rows / 2^32.
      ++times_[k * rows + ((std::uint64_t{random.bits32()} * rows) >> 32U)];
    }
  }
}

JointBootstrap::JointBootstrap(std::span<const double> rows, std::size_t columns,
                               const BootstrapDraws& draws)
    : columns_(columns) {
  HONKA_CHECK(columns > 0 && rows.size() % columns == 0, "rows of equal length");
  const std::size_t n = drawn_rows(rows.size() / columns);
  HONKA_CHECK(draws.rows() == n, "draws of as many rows");
  if (n < 2) return;
  const std::vector<double> runs = runs_of(rows, columns, n);
  resamples_ = draws.resamples();
  sums_.assign(resamples_ * columns, 0.0);
  for (std::size_t k = 0; k < resamples_; ++k) {
    const auto times = draws.times(k);
    double* sum = &sums_[k * columns];
    for (std::size_t i = 0; i < n; ++i) {
      if (times[i] == 0) continue;
      const double weight = times[i];
      const double* run = &runs[i * columns];
      for (std::size_t c = 0; c < columns; ++c) sum[c] += weight * run[c];
    }
  }
}

std::optional<Interval> JointBootstrap::percentiles_of(std::vector<double> values) const {
  if (values.size() < 2 || 2 * values.size() < resamples_) return std::nullopt;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
  };
  return Interval{at(0.025), at(0.975)};
}

}  // namespace honka::eval
