#include "eval/run/localize/options_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

/// What a row of answers comes to.
struct OptionsFigures {
  std::int64_t queries = 0, successes = 0, accepted = 0;
  std::optional<double> error_m;   ///< RMSE of right answers
  std::optional<double> tilt_deg;  ///< the same of their vertical
  double candidates = 0.0, p50_ms = 0.0, p95_ms = 0.0;

  [[nodiscard]] double share(std::int64_t n) const {
    return queries == 0 ? 0.0 : static_cast<double>(n) / static_cast<double>(queries);
  }
};

OptionsFigures figures_of(const OptionsRow& row) {
  OptionsFigures f;
  std::vector<double> errors_m, tilts_deg, times_ms, candidates;
  for (const OptionsAnswer& answer : row.answers) {
    ++f.queries;
    f.accepted += answer.accepted ? 1 : 0;
    if (answer.accepted && answer.right) {
      ++f.successes;
      errors_m.push_back(answer.error_m);
      if (answer.tilt_error_deg) tilts_deg.push_back(*answer.tilt_error_deg);
    }
    times_ms.push_back(answer.time_ms);
    candidates.push_back(answer.candidates);
  }
  f.error_m = rmse(errors_m);
  f.tilt_deg = rmse(tilts_deg);
  f.candidates = mean(candidates).value_or(0.0);
  f.p50_ms = percentile(times_ms, 50.0).value_or(0.0);
  f.p95_ms = percentile(times_ms, 95.0).value_or(0.0);
  return f;
}

double mean_selection(const std::vector<SelectionComparison>& rows,
                      double SelectionComparison::*of) {
  std::vector<double> values;
  for (const SelectionComparison& row : rows) values.push_back(row.*of);
  return mean(values).value_or(NAN);
}

/// The three selections: name, cost, time.
struct SelectionColumn {
  const char* name;
  double SelectionComparison::*cost_m;
  double SelectionComparison::*time_ms;
};
const SelectionColumn kSelectionColumns[] = {
    {"candidates", &SelectionComparison::candidates_m, &SelectionComparison::candidates_ms},
    {"box", &SelectionComparison::box_m, &SelectionComparison::box_ms},
    {"branch_and_bound", &SelectionComparison::global_m, &SelectionComparison::global_ms}};

double median_nodes(const std::vector<SelectionComparison>& rows) {
  std::vector<double> nodes;
  for (const SelectionComparison& row : rows) nodes.push_back(static_cast<double>(row.nodes));
  return median(nodes).value_or(NAN);
}

std::int64_t certified_count(const std::vector<SelectionComparison>& rows) {
  std::int64_t count = 0;
  for (const SelectionComparison& row : rows) count += row.certified ? 1 : 0;
  return count;
}

}  // namespace

Table options_answer_table(const std::vector<OptionsRow>& rows) {
  using Ints = std::vector<std::int64_t>;
  using Words = std::vector<std::string>;
  Table table({{"option", "", "of the localization", Words{}},
               {"method", "", "matcher", Words{}},
               {"query", "", "number over all stands", Ints{}},
               {"accepted", "", "by the matcher", Ints{}},
               {"success", "", "accepted and right", Ints{}},
               {"candidates", "", "pairs of stars within the tolerance", Ints{}},
               {"error_m", "m", "of the answer", std::vector<double>{}},
               {"tilt_error_deg", "deg", "of the answered vertical", std::vector<double>{}},
               {"time_ms", "ms", "of matching", std::vector<double>{}, false}});
  for (const OptionsRow& row : rows) {
    for (std::size_t q = 0; q < row.answers.size(); ++q) {
      const OptionsAnswer& a = row.answers[q];
      table.add_row(row.what.name, row.what.method, q, a.accepted, a.accepted && a.right,
                    a.candidates, a.error_m, a.tilt_error_deg.value_or(NAN), a.time_ms);
    }
  }
  return table;
}

Table selection_row_table(const std::vector<SelectionComparison>& rows) {
  using Ints = std::vector<std::int64_t>;
  using Doubles = std::vector<double>;
  Table table({{"trial", "", "number of the query with matches", Ints{}},
               {"matches", "", "of the query", Ints{}},
               {"candidates_m", "m", "cost a vertex", Doubles{}},
               {"box_m", "m", "cost a vertex", Doubles{}},
               {"branch_and_bound_m", "m", "cost a vertex", Doubles{}},
               {"bound_m", "m", "proved least cost a vertex", Doubles{}},
               {"nodes", "", "of branch and bound", Ints{}},
               {"certified", "", "gap closed", Ints{}}});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SelectionComparison& r = rows[i];
    table.add_row(i, r.matches, r.candidates_m, r.box_m, r.global_m, r.bound_m, r.nodes,
                  r.certified);
  }
  return table;
}

SummaryTable options_json(const std::vector<OptionsRow>& rows, const Scenario& scenario) {
  SummaryTable table;
  for (const OptionsRow& row : rows) {
    const OptionsFigures f = figures_of(row);
    Json json = {{"option", row.what.name},
                 {"method", row.what.method},
                 {"map", row.what.map},
                 {"stems_in_map", row.stems_in_map},
                 {"queries", f.queries},
                 {"success_rate", f.share(f.successes)},
                 {"success_interval", nullptr},
                 {"wrong_rate", f.share(f.accepted - f.successes)},
                 {"refused_rate", f.share(f.queries - f.accepted)},
                 {"translation_rmse_m", f.error_m ? Json(*f.error_m) : Json()},
                 {"tilt_rmse_deg", f.tilt_deg ? Json(*f.tilt_deg) : Json()},
                 {"star_candidates", f.candidates},
                 {"time_ms", {{"p50", f.p50_ms}, {"p95", f.p95_ms}}}};
    if (const auto interval = wilson_interval(f.successes, f.queries)) {
      json["success_interval"] = {interval->low, interval->high};
    }
    table.rows.push_back(std::move(json));
  }
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  table.protocol = fmt::format("{}", fmt::join(options_protocol(scenario), " "));
  return table;
}

SummaryTable selections_json(const std::vector<SelectionComparison>& rows) {
  SummaryTable table;
  table.columns = {"selection", "queries", "cost_a_vertex_m", "time_ms", "nodes", "certified"};
  for (const SelectionColumn& column : kSelectionColumns) {
    const bool bounded = std::string_view(column.name) == "branch_and_bound";
    Json row = {{"selection", column.name},
                {"queries", rows.size()},
                {"cost_a_vertex_m", mean_selection(rows, column.cost_m)},
                {"time_ms", mean_selection(rows, column.time_ms)}};
    row["nodes"] = bounded ? Json(median_nodes(rows)) : Json();
    row["certified"] = bounded ? Json(certified_count(rows)) : Json();
    table.rows.push_back(std::move(row));
  }
  table.protocol = "Eq. (4) over the same matches; means over the queries, nodes a median";
  return table;
}

ReportTable options_table(const std::vector<OptionsRow>& rows) {
  ReportTable table;
  table.title = "Options beside the literal form";
  table.protocol = "the same stem lists for every row";
  table.headers = {{"option"},          {"matcher"},    {"map stems"},    {"queries"},
                   {"success", "%"},    {"wrong", "%"}, {"refused", "%"}, {"error", "m"},
                   {"tilt error", "°"}, {"star pairs"}, {"p50", "ms"},    {"p95", "ms"}};
  for (const OptionsRow& row : rows) {
    const OptionsFigures f = figures_of(row);
    table.rows.push_back({{row.what.name},
                          {row.what.method},
                          {std::to_string(row.stems_in_map)},
                          {std::to_string(f.queries)},
                          {fixed(100.0 * f.share(f.successes), 1)},
                          {fixed(100.0 * f.share(f.accepted - f.successes), 1)},
                          {fixed(100.0 * f.share(f.queries - f.accepted), 1)},
                          {fixed(f.error_m.value_or(NAN), 3)},
                          {fixed(f.tilt_deg.value_or(NAN), 2)},
                          {fixed(f.candidates, 0)},
                          {fixed(f.p50_ms, 3)},
                          {fixed(f.p95_ms, 3)}});
  }
  return table;
}

ReportTable selections_table(const std::vector<SelectionComparison>& rows) {
  ReportTable table;
  table.title = "Eq. (4) by its three selections";
  table.protocol = fmt::format("the same matches of {} queries; means", rows.size());
  table.headers = {
      {"selection"}, {"cost a vertex", "m"}, {"time", "ms"}, {"nodes, median"}, {"certified"}};
  for (const SelectionColumn& column : kSelectionColumns) {
    const bool bounded = std::string_view(column.name) == "branch_and_bound";
    const std::string certified = fmt::format("{} of {}", certified_count(rows), rows.size());
    table.rows.push_back({{column.name},
                          {fixed(mean_selection(rows, column.cost_m), 4)},
                          {fixed(mean_selection(rows, column.time_ms), 3)},
                          {bounded ? fixed(median_nodes(rows), 0) : "–"},
                          {bounded ? certified : "–"}});
  }
  return table;
}

std::vector<std::string> options_protocol(const Scenario& scenario) {
  const OptionsStudySettings& o = scenario.options;
  return {
      fmt::format("{} places a stand, any heading; of each a list of stems within {} m and {}°, "
                  "noise {} m, {} % missed, {} % false.",
                  o.queries, o.list.range_m, o.list.field_of_view_deg, o.list.noise_m,
                  100.0 * o.list.missed_share, 100.0 * o.list.false_share),
      fmt::format("The map is a field inventory of position error {} m, or tree tops of error {} m "
                  "from the air.",
                  scenario.map.sources.inventory.position_error_m,
                  scenario.map.sources.airborne.position_error_m),
      fmt::format("Success: accepted and within {} m and {}°; wrong: accepted and not.",
                  scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg),
      fmt::format("On a slope the sensor stands along the ground and lists the foot of each stem, "
                  "height noise {} m; in space the map has the ground's height at each stem. "
                  "Levelled: turned upright by the true tilt. The other rows take x and y as the "
                  "tilted sensor has them.",
                  o.height_noise_m),
      "A prior of r m is a circle whose middle lies r/2 off the truth; of GNSS, 3 s.d. about a "
      "position with that error.",
      "Star pairs: local and map stars within the tolerance, which are then compared corner by "
      "corner."};
}

}  // namespace honka::eval
