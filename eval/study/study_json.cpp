#include "eval/study/study_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eval/run/localize/localize_results.h"

namespace honka::eval {
namespace {

Json json_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json json_interval(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return Json::array({json_number(interval->low), json_number(interval->high)});
}

void put_axes(Json& row, const Study& study, std::optional<std::int64_t> point) {
  row["point"] = point ? Json(*point) : Json(nullptr);
  for (std::size_t k = 0; k < study.axes().size(); ++k) {
    row[study.axes()[k].key] =
        point ? json_value(study.points.at(static_cast<std::size_t>(*point)).values.at(k))
              : Json(nullptr);
  }
}

void put_pooled(Json& row, const std::string& name, const PooledFigure& figure) {
  row[name] = json_number(figure.value);
  row[name + "_interval"] = json_interval(figure.interval);
  row[name + "_n"] = figure.n;
}

Json json_time(const TimeFigure& time, double scale) {
  const auto scaled = [&](std::optional<double> value) {
    return value ? json_number(scale * *value) : Json(nullptr);
  };
  return {{"p50", scaled(time.p50)}, {"p95", scaled(time.p95)}};
}

/// The first time of a kind stands under the key that all tables share.
void put_times(Json& row, const Study& study, const CellSummary& cell) {
  const MeasuresByKind by_kind(*study.kind);
  for (std::size_t k = 0; k < by_kind.times.size(); ++k) {
    const Measure& measure = study.kind->measures[by_kind.times[k]];
    const bool seconds = measure.unit == "s";
    if (k == 0) {
      row["time_ms"] = json_time(cell.times[k], seconds ? 1000.0 : 1.0);
    } else {
      row[measure.name] = json_time(cell.times[k], 1.0);
    }
  }
}

Json cell_row(const Study& study, const CellSummary& cell, const PointCost& cost) {
  const MeasuresByKind by_kind(*study.kind);
  const auto name = [&](std::size_t measure) { return study.kind->measures[measure].name; };
  Json row;
  put_axes(row, study, cell.point);
  row["method"] = study.methods[cell.method];
  row["trials"] = cell.trials;
  row["failed"] = cell.failed();
  row["failed_by"] = Json::object();
  for (const auto& [status, count] : cell.failed_by) row["failed_by"][status] = count;
  for (std::size_t k = 0; k < by_kind.rates.size(); ++k) {
    const std::string measure = name(by_kind.rates[k]);
    const RateFigure& rate = cell.rates[k];
    row[measure + "_rate"] = rate.of > 0 ? Json(rate.rate) : Json(nullptr);
    row[measure + "_interval"] = json_interval(rate.interval);
    row[measure + "_design_effect"] = json_number(rate.design_effect);
  }
  for (std::size_t k = 0; k < by_kind.errors.size(); ++k) {
    put_pooled(row, name(by_kind.errors[k]), cell.errors[k]);
  }
  if (by_kind.error_m) put_pooled(row, "error_over_bound", cell.over_bound);
  for (std::size_t k = 0; k < by_kind.values.size(); ++k) {
    put_pooled(row, name(by_kind.values[k]), cell.values[k]);
  }
  put_times(row, study, cell);
  row["wall_s"] = json_time(cost.wall_s, 1.0);
  row["resident_mb"] = json_number(cost.resident_mb);
  return row;
}

Json pair_row(const Study& study, const PairedFigure& pair) {
  Json row;
  put_axes(row, study, pair.point);
  row["measure"] = study.kind->measures[pair.measure].name;
  row["first"] = study.methods[pair.first];
  row["second"] = study.methods[pair.second];
  row["first_value"] = json_number(pair.first_value);
  row["second_value"] = json_number(pair.second_value);
  row["difference"] = json_number(pair.difference);
  row["interval"] = json_interval(pair.interval);
  row["n"] = pair.n;
  row["of"] = pair.of;
  row["first_only"] = pair.counts ? Json(pair.counts->first_only) : Json(nullptr);
  row["second_only"] = pair.counts ? Json(pair.counts->second_only) : Json(nullptr);
  row["mcnemar_p"] = json_number(pair.mcnemar);
  row["better"] = pair.better ? Json(study.methods[*pair.better]) : Json(nullptr);
  row["verdict"] = verdict_of(study, pair);
  return row;
}

Json convergence_row(const Study& study, const ConvergenceFigure& figure) {
  Json row;
  row["trials"] = figure.trials;
  row["method"] = study.methods[figure.method];
  row["half_width"] = figure.rate.half_width();
  row["widest_at_point"] = figure.point;
  return row;
}

SummaryTable table_with(std::vector<Json> rows, const std::string& protocol) {
  SummaryTable table;
  table.rows = std::move(rows);
  table.protocol = protocol;
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  return table;
}

}  // namespace

Json json_value(const Value& value) {
  return std::visit([](const auto& held) { return Json(held); }, value);
}

StudySummary summarize_study(const Study& study, const Table& trials) {
  const std::vector<StudyCell> cells = study_cells(study, trials);
  StudyDraws draws;
  return {summarize_cells(study, trials, cells, draws), point_costs(study, trials, cells),
          compare_methods(study, trials, cells, draws), convergence_of(study, trials, cells)};
}

std::map<std::string, SummaryTable> study_json(const Study& study, const StudySummary& summary,
                                               const std::vector<std::string>& protocol) {
  std::string sentences;
  for (const std::string& one : protocol) sentences += (sentences.empty() ? "" : " ") + one;
  std::vector<Json> cells, pairs, convergence;
  for (const CellSummary& cell : summary.cells) {
    cells.push_back(cell_row(study, cell, summary.costs.at(static_cast<std::size_t>(cell.point))));
  }
  for (const PairedFigure& pair : summary.pairs) pairs.push_back(pair_row(study, pair));
  for (const ConvergenceFigure& figure : summary.convergence.curve) {
    convergence.push_back(convergence_row(study, figure));
  }
  std::map<std::string, SummaryTable> tables;
  tables["paired"] =
      table_with(std::move(pairs), fmt::format("difference = second − first. {}", sentences));
  tables["convergence"] =
      table_with(std::move(convergence), convergence_line(study, summary.convergence));
  tables[table_name_of(study.base)] = table_with(std::move(cells), sentences);
  return tables;
}

std::map<std::string, Metric> study_metrics(const Study& study, const Table& trials,
                                            const StudySummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  const std::vector<StudyCell> cells = study_cells(study, trials);
  std::map<std::string, Metric> metrics;
  std::int64_t failed = 0, all = 0;
  for (const CellSummary& cell : summary.cells) {
    if (cell.method != 0) continue;
    failed += cell.failed();
    all += cell.trials;
  }
  metrics["failed_trials"] = {static_cast<double>(failed), "", all, all, {}, {}};
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    std::vector<std::size_t> rows;
    std::vector<std::int64_t> worlds;
    for (const StudyCell& cell : cells) {
      if (cell.method != method) continue;
      rows.insert(rows.end(), cell.rows.begin(), cell.rows.end());
      worlds.insert(worlds.end(), cell.worlds.begin(), cell.worlds.end());
    }
    if (rows.empty()) continue;
    for (const std::size_t measure : by_kind.rates) {
      const std::string& name = study.kind->measures[measure].name;
      const RateFigure rate = rate_figure(outcomes(trials, name, rows), worlds);
      metrics[fmt::format("{}_{}_rate", study.methods[method], name)] = {
          rate.rate, "", rate.of, rate.of, {{rate.interval.low, rate.interval.high}}, {}};
    }
  }
  if (const auto& widest = summary.convergence.widest) {
    metrics["half_width"] = {widest->rate.half_width(), "", widest->rate.of,
                             widest->rate.of,           {}, {}};
  }
  return metrics;
}

}  // namespace honka::eval
