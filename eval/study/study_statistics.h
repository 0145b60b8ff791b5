#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/metrics/clusters.h"
#include "eval/metrics/statistics.h"
#include "eval/study/pooled_sample.h"
#include "eval/study/study.h"

namespace honka::eval {

/// A rate over all trials: failed ones count, as 0.
struct RateFigure {
  std::int64_t successes = 0, of = 0;
  double rate = 0.0;
  Interval interval;  ///< 95 %, as clustered_rate_interval()
  double design_effect = 1.0;

  [[nodiscard]] double half_width() const { return 0.5 * (interval.high - interval.low); }
};

struct TimeFigure {
  std::optional<double> p50, p95;
};

/// One method at one point. Figures stand in the order of their kind in StudyKind::measures.
struct CellSummary {
  std::int64_t point = 0;
  std::size_t method = 0;  ///< index into Study::methods
  std::int64_t trials = 0;
  std::map<std::string, std::int64_t> failed_by;  ///< status → trials, failed ones alone
  std::vector<RateFigure> rates;
  std::vector<PooledFigure> errors, values;
  std::vector<TimeFigure> times;
  PooledFigure over_bound;  ///< RMS error over RMS bound, where the kind has both

  [[nodiscard]] std::int64_t failed() const;
};

/// What the trials of a point cost; all methods together.
struct PointCost {
  TimeFigure wall_s;
  std::optional<double> cpu_s;        ///< median
  std::optional<double> resident_mb;  ///< most
};

/// Measures of a study by kind, as indices into StudyKind::measures.
struct MeasuresByKind {
  std::vector<std::size_t> rates, errors, values, times;
  std::optional<std::size_t> error_m, bound_m;  ///< both or neither

  explicit MeasuresByKind(const StudyKind& kind);
};

/// Rows of a study's table at one point by one method, in order of trial.
struct StudyCell {
  std::int64_t point = 0;
  std::size_t method = 0;
  std::vector<std::size_t> rows;
  std::vector<std::int64_t> worlds;  ///< of each row
};

/// One cell a point and method, point by point; also where a point has no rows.
[[nodiscard]] std::vector<StudyCell> study_cells(const Study& study, const Table& trials);

/// The figures of every cell, in the order of study_cells().
[[nodiscard]] std::vector<CellSummary> summarize_cells(const Study& study, const Table& trials,
                                                       const std::vector<StudyCell>& cells,
                                                       StudyDraws& draws);

/// One a point.
[[nodiscard]] std::vector<PointCost> point_costs(const Study& study, const Table& trials,
                                                 const std::vector<StudyCell>& cells);

/// A column at some rows.
[[nodiscard]] std::vector<double> taken(const std::vector<double>& column,
                                        const std::vector<std::size_t>& rows);

/// 1 where a rate's measure is 1, 0 where it is 0 or the trial failed, in the order of `rows`.
[[nodiscard]] std::vector<double> outcomes(const Table& trials, const std::string& measure,
                                           const std::vector<std::size_t>& rows);

/// A rate of 0s and 1s, with its interval; `outcomes` is not empty.
[[nodiscard]] RateFigure rate_figure(const std::vector<double>& outcomes,
                                     const std::vector<std::int64_t>& worlds);

}  // namespace honka::eval
