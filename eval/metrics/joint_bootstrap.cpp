#include "eval/metrics/joint_bootstrap.h"

#include "algo/types/check.h"
#include "algo/types/random.h"

namespace honka::eval {
namespace {

/// Sums of runs of consecutive rows, at most so many runs.
std::vector<double> runs_of(std::span<const double> rows, std::size_t columns, std::size_t limit) {
  const std::size_t n = rows.size() / columns, runs = std::min(n, limit);
  std::vector<double> sums(runs * columns, 0.0);
  for (std::size_t row = 0; row < n; ++row) {
    double* sum = &sums[row * runs / n * columns];
    for (std::size_t c = 0; c < columns; ++c) sum[c] += rows[row * columns + c];
  }
  return sums;
}

}  // namespace

JointBootstrap::JointBootstrap(std::span<const double> rows, std::size_t columns,
                               const BootstrapSettings& settings)
    : columns_(columns) {
  HONKA_CHECK(columns > 0 && rows.size() % columns == 0, "rows of equal length");
  HONKA_CHECK(settings.resamples > 0, "a bootstrap needs resamples");
  const std::vector<double> runs = runs_of(rows, columns, kDrawnRows);
  const std::size_t n = runs.size() / columns;
  if (n < 2) return;
  resamples_ = static_cast<std::size_t>(settings.resamples);
  sums_.assign(resamples_ * columns, 0.0);
  RandomStream random(settings.seed, settings.name);
  for (std::size_t k = 0; k < resamples_; ++k) {
    double* sum = &sums_[k * columns];
    for (std::size_t i = 0; i < n; ++i) {
      // Multiply and shift; the bias is below n / 2^32.
      const std::uint64_t drawn = (std::uint64_t{random.bits32()} * n) >> 32U;
      const double* run = &runs[drawn * columns];
      for (std::size_t c = 0; c < columns; ++c) sum[c] += run[c];
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
