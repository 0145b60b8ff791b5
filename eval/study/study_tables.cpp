#include "eval/study/study_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/report/console_table.h"

namespace honka::eval {
namespace {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

std::string percent_interval(const Interval& interval) {
  return fmt::format("{:.1f} – {:.1f}", 100.0 * interval.low, 100.0 * interval.high);
}

/// Three digits that matter; "–" for nothing.
std::string short_number(const std::optional<double>& value) {
  if (!value || !std::isfinite(*value)) return "–";
  const double size = std::abs(*value);
  const int places = size == 0.0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(size)));
  return fixed(*value, std::clamp(places, 0, 6));
}

std::string short_time(const TimeFigure& time) {
  return fmt::format("{} / {}", short_number(time.p50), short_number(time.p95));
}

std::string failed_text(const CellSummary& cell) {
  std::vector<std::string> causes;
  for (const auto& [status, count] : cell.failed_by) {
    causes.push_back(fmt::format("{} {}", count, status));
  }
  return causes.empty() ? "0" : fmt::format("{}", fmt::join(causes, ", "));
}

std::vector<ReportHeader> axis_headers(const Study& study) {
  std::vector<ReportHeader> headers;
  for (const StudyAxis& axis : study.axes()) headers.push_back({axis.key});
  headers.push_back({"method"});
  return headers;
}

std::vector<ReportCell> axis_cells(const Study& study, std::int64_t point,
                                   const std::string& method) {
  std::vector<ReportCell> cells;
  for (const std::string& text : axis_texts(study, point)) cells.push_back({text});
  cells.push_back({method});
  return cells;
}

/// The name of a measure without the unit that stands below it.
ReportHeader measure_header(const Measure& measure) {
  const std::string tail = fmt::format("_{}", measure.unit);
  const bool tailed = !measure.unit.empty() && measure.name.ends_with(tail);
  return {tailed ? measure.name.substr(0, measure.name.size() - tail.size()) : measure.name,
          measure.unit};
}

void add_result_headers(ReportTable& table, const Study& study, const MeasuresByKind& by_kind) {
  const auto& measures = study.kind->measures;
  for (std::size_t k = 0; k < by_kind.rates.size(); ++k) {
    table.headers.push_back({measures[by_kind.rates[k]].name, "%"});
    if (k == 0) table.headers.push_back({"95 % interval", "%"});
  }
  table.headers.push_back({"trials"});
  table.headers.push_back({"failed"});
  if (!by_kind.errors.empty()) {
    const Measure& error = measures[by_kind.errors.front()];
    table.headers.push_back(measure_header(error));
  }
  if (by_kind.error_m) table.headers.push_back({"error / bound"});
  if (!by_kind.times.empty()) {
    const Measure& time = measures[by_kind.times.front()];
    table.headers.push_back({measure_header(time).name + " p50 / p95", time.unit});
  }
}

std::vector<ReportCell> result_row(const Study& study, const MeasuresByKind& by_kind,
                                   const CellSummary& cell) {
  std::vector<ReportCell> row = axis_cells(study, cell.point, study.methods[cell.method]);
  for (std::size_t k = 0; k < cell.rates.size(); ++k) {
    row.push_back({fixed(cell.trials > 0 ? 100.0 * cell.rates[k].rate : kNoFigure, 1)});
    if (k == 0) row.push_back({percent_interval(cell.rates[k].interval)});
  }
  row.push_back({fmt::format("{}", cell.trials)});
  row.push_back({failed_text(cell)});
  if (!cell.errors.empty()) row.push_back({short_number(cell.errors.front().value)});
  if (by_kind.error_m) row.push_back({short_number(cell.over_bound.value)});
  if (!cell.times.empty()) row.push_back({short_time(cell.times.front())});
  return row;
}

/// "0.0449 [0.0325 – 0.0576]".
std::string pooled_text(const PooledFigure& figure) {
  if (!figure.interval) return short_number(figure.value);
  return fmt::format("{} [{} – {}]", short_number(figure.value), short_number(figure.interval->low),
                     short_number(figure.interval->high));
}

/// A point | method | rate [interval] | error | time.
ReportTable console_rows(const Study& study, const StudySummary& summary, std::size_t limit) {
  const MeasuresByKind by_kind(*study.kind);
  const auto& measures = study.kind->measures;
  ReportTable table;
  table.title = study.base.scenario.title.empty() ? study.base.name : study.base.scenario.title;
  table.headers = axis_headers(study);
  if (!by_kind.rates.empty()) {
    table.headers.push_back({measures[by_kind.rates.front()].name + " [95 %]", "%"});
  }
  if (!by_kind.errors.empty()) {
    const Measure& error = measures[by_kind.errors.front()];
    table.headers.push_back({measure_header(error).name + " RMSE", error.unit});
  }
  if (!by_kind.times.empty()) {
    const Measure& time = measures[by_kind.times.front()];
    table.headers.push_back({measure_header(time).name + " p50", time.unit});
  }
  table.headers.push_back({"failed"});
  for (const CellSummary& cell : summary.cells) {
    if (table.rows.size() == limit) break;
    auto row = axis_cells(study, cell.point, study.methods[cell.method]);
    if (!cell.rates.empty()) {
      const RateFigure& rate = cell.rates.front();
      row.push_back(
          {fmt::format("{} [{}]", fixed(100.0 * rate.rate, 1), percent_interval(rate.interval))});
    }
    if (!cell.errors.empty()) row.push_back({short_number(cell.errors.front().value)});
    if (!cell.times.empty()) row.push_back({short_number(cell.times.front().p50)});
    row.push_back({failed_text(cell)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<std::string> axis_texts(const Study& study, std::int64_t point) {
  std::vector<std::string> texts;
  for (const Value& value : study.points.at(static_cast<std::size_t>(point)).values) {
    const auto* text = std::get_if<std::string>(&value);
    const auto* number = std::get_if<double>(&value);
    texts.push_back(text ? *text : number ? fmt::format("{}", *number) : format_value(value));
  }
  return texts;
}

ReportTable study_result_table(const Study& study, const StudySummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  ReportTable table;
  table.title = "Results";
  table.protocol = fmt::format(
      "up to {} trials at each of {} points; rates over all trials, failed "
      "ones too; errors: RMSE over the trials that have one",
      summary.convergence.most, study.points.size());
  table.headers = axis_headers(study);
  add_result_headers(table, study, by_kind);
  for (const CellSummary& cell : summary.cells) {
    table.rows.push_back(result_row(study, by_kind, cell));
  }
  return table;
}

ReportTable study_error_table(const Study& study, const StudySummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  ReportTable table;
  table.title = "Errors and means";
  table.protocol = "errors: RMSE; the others: means; over the trials that have one; 95 % intervals";
  table.headers = axis_headers(study);
  for (const std::size_t k : by_kind.errors) {
    table.headers.push_back(measure_header(study.kind->measures[k]));
  }
  for (const std::size_t k : by_kind.values) {
    table.headers.push_back(measure_header(study.kind->measures[k]));
  }
  if (!by_kind.errors.empty()) table.headers.push_back({"n of N"});
  for (const CellSummary& cell : summary.cells) {
    auto row = axis_cells(study, cell.point, study.methods[cell.method]);
    for (const PooledFigure& error : cell.errors) row.push_back({pooled_text(error)});
    for (const PooledFigure& value : cell.values) row.push_back({pooled_text(value)});
    if (!cell.errors.empty()) {
      row.push_back({fmt::format("{} of {}", cell.errors.front().n, cell.trials)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable study_pair_table(const Study& study, const StudySummary& summary) {
  ReportTable table;
  table.title = "Methods against each other";
  table.protocol = "the same trials; all points together first; 95 % intervals";
  table.headers = {{"point"}, {"measure"}, {"p (McNemar)"}, {"verdict"}};
  for (const PairedFigure& pair : summary.pairs) {
    const std::string where = pair.point ? point_name(study, *pair.point) : "all points";
    table.rows.push_back({{where},
                          {study.kind->measures[pair.measure].name},
                          {pair.mcnemar ? fmt::format("{:.2g}", *pair.mcnemar) : "–"},
                          {verdict_of(study, pair)}});
  }
  return table;
}

ReportTable study_cost_table(const Study& study, const StudySummary& summary) {
  const MeasuresByKind by_kind(*study.kind);
  ReportTable table;
  table.title = "Time and memory";
  table.protocol =
      "a trial: all methods, and its world if it had to be made; memory: resident pages of the "
      "worker when a trial ended, most at the point";
  table.headers = axis_headers(study);
  for (const std::size_t k : by_kind.times) {
    const Measure& measure = study.kind->measures[k];
    table.headers.push_back({measure_header(measure).name + " p50 / p95", measure.unit});
  }
  table.headers.push_back({"a trial p50 / p95", "s"});
  table.headers.push_back({"processor, median", "s"});
  table.headers.push_back({"memory", "MB"});
  for (const CellSummary& cell : summary.cells) {
    const PointCost& cost = summary.costs.at(static_cast<std::size_t>(cell.point));
    auto row = axis_cells(study, cell.point, study.methods[cell.method]);
    for (const TimeFigure& time : cell.times) row.push_back({short_time(time)});
    row.push_back({short_time(cost.wall_s)});
    row.push_back({short_number(cost.cpu_s)});
    row.push_back({short_number(cost.resident_mb)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::vector<std::string> pooled_verdicts(const Study& study, const StudySummary& summary) {
  std::vector<std::string> verdicts;
  for (const PairedFigure& pair : summary.pairs) {
    if (pair.point) continue;
    const std::string where = study.points.size() > 1 ? "Over all points, " : "";
    verdicts.push_back(where + verdict_of(study, pair) + ".");
  }
  return verdicts;
}

std::string study_console_text(const Study& study, const StudySummary& summary) {
  constexpr std::size_t kRowsThatFit = 40;
  ReportTable table = console_rows(study, summary, kRowsThatFit);
  if (summary.cells.size() > kRowsThatFit) {
    table.notes.push_back(
        fmt::format("… and {} rows more, in report.html", summary.cells.size() - kRowsThatFit));
  }
  for (const std::string& verdict : pooled_verdicts(study, summary)) table.notes.push_back(verdict);
  table.notes.push_back(convergence_line(study, summary.convergence));
  return console_table(table);
}

}  // namespace honka::eval
