#include "eval/study/study_statistics.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"
#include "eval/run/parallel.h"
#include "eval/run/thread_count.h"

namespace honka::eval {
namespace {

std::size_t method_index(const Study& study, const std::string& name) {
  const auto at = std::find(study.methods.begin(), study.methods.end(), name);
  HONKA_CHECK(at != study.methods.end(), "a row names a method of the study");
  return static_cast<std::size_t>(at - study.methods.begin());
}

std::vector<double> known_of(const std::vector<double>& column,
                             const std::vector<std::size_t>& rows) {
  std::vector<double> values;
  for (const std::size_t row : rows) {
    if (std::isfinite(column[row])) values.push_back(column[row]);
  }
  return values;
}

TimeFigure time_figure(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  const std::vector<double> values = known_of(column, rows);
  return {percentile(values, 50.0), percentile(values, 95.0)};
}

/// The measures that are pooled over trials.
void pool(const Study& study, const Table& trials, const StudyCell& cell, StudyDraws& draws,
          CellSummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  const auto values = [&](std::size_t measure) {
    return taken(trials.doubles(study.kind->measures[measure].name), cell.rows);
  };
  PooledSample sample(cell.worlds);
  std::vector<std::size_t> errors, means;
  for (const std::size_t m : by_kind.errors) errors.push_back(sample.add_squares(values(m)));
  for (const std::size_t m : by_kind.values) means.push_back(sample.add_values(values(m)));
  std::optional<std::size_t> pair;
  if (by_kind.error_m) {
    pair = sample.add_square_pair(values(*by_kind.error_m), values(*by_kind.bound_m));
  }
  sample.draw(draws);
  for (const std::size_t k : errors) summary.errors.push_back(sample.rms(k));
  for (const std::size_t k : means) summary.values.push_back(sample.mean(k));
  if (pair) summary.over_bound = sample.rms_ratio(*pair);
}

CellSummary summarize_cell(const Study& study, const Table& trials, const StudyCell& cell,
                           StudyDraws& draws) {
  const MeasuresByKind by_kind(*study.kind);
  const auto name = [&](std::size_t measure) { return study.kind->measures[measure].name; };
  CellSummary summary;
  summary.point = cell.point;
  summary.method = cell.method;
  summary.trials = static_cast<std::int64_t>(cell.rows.size());
  for (const std::size_t row : cell.rows) {
    const std::string& status = trials.strings("status")[row];
    if (status != name_of(TrialStatus::kDone)) ++summary.failed_by[status];
  }
  for (const std::size_t measure : by_kind.rates) {
    summary.rates.push_back(rate_figure(outcomes(trials, name(measure), cell.rows), cell.worlds));
  }
  for (const std::size_t measure : by_kind.times) {
    summary.times.push_back(time_figure(trials.doubles(name(measure)), cell.rows));
  }
  pool(study, trials, cell, draws, summary);
  return summary;
}

}  // namespace

std::int64_t CellSummary::failed() const {
  std::int64_t sum = 0;
  for (const auto& [status, count] : failed_by) sum += count;
  return sum;
}

MeasuresByKind::MeasuresByKind(const StudyKind& kind) {
  for (std::size_t k = 0; k < kind.measures.size(); ++k) {
    const Measure& measure = kind.measures[k];
    switch (measure.kind) {
      case MeasureKind::kRate:
        rates.push_back(k);
        break;
      case MeasureKind::kError:
        errors.push_back(k);
        break;
      case MeasureKind::kValue:
        values.push_back(k);
        break;
      case MeasureKind::kTime:
        times.push_back(k);
        break;
    }
    if (measure.name == "translation_error_m") error_m = k;
    if (measure.name == "bound_m") bound_m = k;
  }
  if (!error_m || !bound_m) error_m = bound_m = std::nullopt;
}

std::vector<StudyCell> study_cells(const Study& study, const Table& trials) {
  const std::size_t methods = study.methods.size();
  const std::int64_t worlds = study.base.scenario.study.worlds;
  std::vector<StudyCell> cells(study.points.size() * methods);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    cells[k].point = static_cast<std::int64_t>(k / methods);
    cells[k].method = k % methods;
  }
  const auto& points = trials.ints("point");
  const auto& numbers = trials.ints("trial");
  const auto& names = trials.strings("method");
  for (std::size_t row = 0; row < trials.rows(); ++row) {
    const auto point = static_cast<std::size_t>(points[row]);
    StudyCell& cell = cells.at(point * methods + method_index(study, names[row]));
    cell.rows.push_back(row);
    cell.worlds.push_back(numbers[row] % worlds);
  }
  return cells;
}

std::vector<CellSummary> summarize_cells(const Study& study, const Table& trials,
                                         const std::vector<StudyCell>& cells, StudyDraws& draws) {
  std::vector<CellSummary> summaries(cells.size());
  for_each_index(cells.size(), thread_count(0), [&](std::size_t k) {
    summaries[k] = summarize_cell(study, trials, cells[k], draws);
  });
  return summaries;
}

std::vector<PointCost> point_costs(const Study& study, const Table& trials,
                                   const std::vector<StudyCell>& cells) {
  std::vector<PointCost> costs;
  for (std::size_t k = 0; k < cells.size(); k += study.methods.size()) {
    const std::vector<std::size_t>& rows = cells[k].rows;
    costs.push_back({time_figure(trials.doubles("wall_s"), rows),
                     median(known_of(trials.doubles("cpu_s"), rows)),
                     maximum(known_of(trials.doubles("resident_mb"), rows))});
  }
  return costs;
}

std::vector<double> taken(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) values.push_back(column[row]);
  return values;
}

std::vector<double> outcomes(const Table& trials, const std::string& measure,
                             const std::vector<std::size_t>& rows) {
  const std::vector<double>& column = trials.doubles(measure);
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) values.push_back(column[row] == 1.0 ? 1.0 : 0.0);
  return values;
}

RateFigure rate_figure(const std::vector<double>& outcomes,
                       const std::vector<std::int64_t>& worlds) {
  RateFigure figure;
  figure.of = static_cast<std::int64_t>(outcomes.size());
  figure.successes = std::count(outcomes.begin(), outcomes.end(), 1.0);
  const ClusterSpread spread = cluster_spread(outcomes, worlds);
  figure.design_effect = spread.design_effect;
  figure.interval = clustered_rate_interval(figure.successes, figure.of, spread.widening)
                        .value_or(Interval{0.0, 1.0});
  if (figure.of > 0) {
    figure.rate = static_cast<double>(figure.successes) / static_cast<double>(figure.of);
  }
  return figure;
}

}  // namespace honka::eval
