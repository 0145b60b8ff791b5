#include "eval/study/pooled_sample.h"

#include <cmath>
#include <limits>

#include "algo/types/check.h"
#include "eval/metrics/clusters.h"

namespace honka::eval {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
constexpr double kNoLeast = -std::numeric_limits<double>::infinity();

std::vector<double> squares_of(std::vector<double> values) {
  for (double& value : values) value *= value;
  return values;
}

/// Mean of a measure within a draw, from its two columns: sum and number.
double drawn_mean(std::span<const double> sums, std::size_t measure) {
  return sums[2 * measure] / sums[2 * measure + 1];
}

}  // namespace

const BootstrapDraws& StudyDraws::of(std::size_t rows) {
  const std::lock_guard lock(mutex_);
  const auto found = by_rows_.find(rows);
  if (found != by_rows_.end()) return found->second;
  return by_rows_.emplace(rows, BootstrapDraws(rows, {1, "study", kResamples})).first->second;
}

std::size_t PooledSample::add_values(const std::vector<double>& values) {
  HONKA_CHECK(values.size() == worlds_.size(), "one value a trial");
  columns_.push_back(values);
  return columns_.size() - 1;
}

std::size_t PooledSample::add_squares(const std::vector<double>& values) {
  return add_values(squares_of(values));
}

std::size_t PooledSample::add_square_pair(std::vector<double> first, std::vector<double> second) {
  HONKA_CHECK(first.size() == second.size(), "pairs");
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (!std::isfinite(first[k]) || !std::isfinite(second[k])) first[k] = second[k] = kMissing;
  }
  const std::size_t pair = add_squares(first);
  (void)add_squares(second);
  return pair;
}

void PooledSample::draw(StudyDraws& draws) {
  const std::size_t width = 2 * columns_.size();
  if (width == 0) return;
  std::vector<double> rows(worlds_.size() * width, 0.0);
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    for (std::size_t k = 0; k < worlds_.size(); ++k) {
      if (!std::isfinite(columns_[c][k])) continue;
      rows[k * width + 2 * c] = columns_[c][k];
      rows[k * width + 2 * c + 1] = 1.0;
    }
  }
  bootstrap_.emplace(rows, width, draws.of(JointBootstrap::drawn_rows(worlds_.size())));
}

double PooledSample::mean_of(std::size_t measure) const {
  double sum = 0.0, count = 0.0;
  for (const double value : columns_.at(measure)) {
    if (!std::isfinite(value)) continue;
    sum += value;
    count += 1.0;
  }
  return sum / count;
}

double PooledSample::widening(const std::vector<Influence>& influences) const {
  std::vector<double> values;
  std::vector<std::int64_t> worlds;
  for (std::size_t k = 0; k < worlds_.size(); ++k) {
    double value = 0.0;
    for (const Influence& i : influences) value += i.weight * columns_[i.measure][k];
    if (!std::isfinite(value)) continue;
    values.push_back(value);
    worlds.push_back(worlds_[k]);
  }
  return cluster_spread(values, worlds).widening;
}

template <class Statistic>
PooledFigure PooledSample::figure(const std::vector<Influence>& influences, double least,
                                  const Statistic& statistic) const {
  HONKA_CHECK(bootstrap_.has_value(), "draw() comes before figures");
  PooledFigure figure;
  figure.of = static_cast<std::int64_t>(worlds_.size());
  for (const double value : columns_.at(influences.front().measure)) {
    figure.n += std::isfinite(value) ? 1 : 0;
  }
  const double value = statistic([this](std::size_t measure) { return mean_of(measure); });
  if (!std::isfinite(value)) return figure;
  figure.value = value;
  if (figure.n < 2) return figure;
  const auto interval = bootstrap_->interval([&](std::span<const double> sums) {
    return statistic([sums](std::size_t measure) { return drawn_mean(sums, measure); });
  });
  if (interval) figure.interval = widened(*interval, value, widening(influences), least);
  return figure;
}

PooledFigure PooledSample::mean(std::size_t measure) const {
  return figure({{measure}}, kNoLeast, [=](const auto& means) { return means(measure); });
}

PooledFigure PooledSample::rms(std::size_t measure) const {
  return figure({{measure}}, 0.0, [=](const auto& means) { return std::sqrt(means(measure)); });
}

PooledFigure PooledSample::rms_ratio(std::size_t pair) const {
  const double ratio = mean_of(pair) / mean_of(pair + 1);
  return figure({{pair, 1.0}, {pair + 1, -ratio}}, 0.0,
                [=](const auto& means) { return std::sqrt(means(pair) / means(pair + 1)); });
}

PooledFigure PooledSample::rms_difference(std::size_t pair) const {
  // d√m = dm / (2√m); a mean of 0 moves nothing, as all its values are 0.
  const auto slope = [this](std::size_t measure) {
    const double m = mean_of(measure);
    return m > 0.0 ? 0.5 / std::sqrt(m) : 0.0;
  };
  return figure(
      {{pair, slope(pair)}, {pair + 1, -slope(pair + 1)}}, kNoLeast,
      [=](const auto& means) { return std::sqrt(means(pair)) - std::sqrt(means(pair + 1)); });
}

}  // namespace honka::eval
