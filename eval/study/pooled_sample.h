#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "eval/metrics/joint_bootstrap.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {

/// An RMSE, a mean, or what is made of two, over the trials in which the measure is finite; nothing
/// where in none.
struct PooledFigure {
  std::optional<double> value;
  std::optional<Interval> interval;  ///< bootstrap, 95 %
  std::int64_t n = 0, of = 0;
};

/// The draws of every bootstrap of a study, by number of rows; several threads may ask.
class StudyDraws {
 public:
  /// Resamples: the ends of an interval then vary by some 3 % of its width.
  static constexpr int kResamples = 1000;

  [[nodiscard]] const BootstrapDraws& of(std::size_t rows);

 private:
  std::mutex mutex_;
  std::map<std::size_t, BootstrapDraws> by_rows_;
};

/// Measures of the same trials, and one bootstrap for all that is pooled from them. Intervals are
/// widened where worlds differ by more than chance (cluster_spread()).
class PooledSample {
 public:
  /// `worlds`: of each trial.
  explicit PooledSample(const std::vector<std::int64_t>& worlds) : worlds_(worlds) {}

  /// Adds a measure, one value a trial, NaN where it has none, to be pooled by its mean, or by the
  /// root of the mean of its squares. Returns its number. Before draw().
  [[nodiscard]] std::size_t add_values(const std::vector<double>& values);
  [[nodiscard]] std::size_t add_squares(const std::vector<double>& values);
  /// Adds the squares of two, where both are finite; the second has the next number.
  [[nodiscard]] std::size_t add_square_pair(std::vector<double> first, std::vector<double> second);

  /// Draws the resamples.
  void draw(StudyDraws& draws);

  [[nodiscard]] PooledFigure mean(std::size_t measure) const;
  [[nodiscard]] PooledFigure rms(std::size_t measure) const;
  /// RMS / RMS and RMS − RMS of a pair.
  [[nodiscard]] PooledFigure rms_ratio(std::size_t pair) const;
  [[nodiscard]] PooledFigure rms_difference(std::size_t pair) const;

 private:
  struct Influence {
    std::size_t measure = 0;
    double weight = 1.0;
  };

  [[nodiscard]] double mean_of(std::size_t measure) const;
  /// statistic(means of the measures), bounded below by `least`; the weights are its derivatives.
  template <class Statistic>
  [[nodiscard]] PooledFigure figure(const std::vector<Influence>& influences, double least,
                                    const Statistic& statistic) const;
  [[nodiscard]] double widening(const std::vector<Influence>& influences) const;

  std::vector<std::int64_t> worlds_;
  std::vector<std::vector<double>> columns_;  ///< NaN where a trial has no value
  std::optional<JointBootstrap> bootstrap_;
};

}  // namespace honka::eval
