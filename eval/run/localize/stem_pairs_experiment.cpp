#include "eval/run/localize/stem_pairs_experiment.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/metrics/statistics.h"
#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/sighting_figures.h"
#include "eval/run/localize/stem_pairs.h"

namespace honka::eval {
namespace {

/// The pairs of one method, or its wrong combinations.
struct StemPairGroup {
  std::string method;
  bool pairs = true;
  std::vector<const StemPairRow*> rows;

  [[nodiscard]] std::int64_t count(bool (*is)(const StemPairRow&)) const {
    return std::count_if(rows.begin(), rows.end(), [&](const auto* row) { return is(*row); });
  }
  [[nodiscard]] std::int64_t accepted() const {
    return count([](const StemPairRow& row) { return row.result.accepted(); });
  }
  [[nodiscard]] std::int64_t successes() const {
    return count([](const StemPairRow& row) { return row.success; });
  }
  [[nodiscard]] std::int64_t size() const { return static_cast<std::int64_t>(rows.size()); }
};

std::vector<StemPairGroup> groups_of_pairs(const std::vector<StemPairRow>& rows) {
  std::vector<StemPairGroup> groups;
  for (const bool pairs : {true, false}) {
    for (const StemPairRow& row : rows) {
      if (row.same_plot != pairs) continue;
      auto group = std::find_if(groups.begin(), groups.end(), [&](const StemPairGroup& g) {
        return g.method == row.method && g.pairs == pairs;
      });
      if (group == groups.end()) group = groups.insert(group, {row.method, pairs, {}});
      group->rows.push_back(&row);
    }
  }
  return groups;
}

/// Greatest deviation of the accepted pairs; nothing where none was accepted.
std::optional<double> greatest(const StemPairGroup& group, double (*of)(const StemPairRow&)) {
  std::vector<double> values;
  for (const StemPairRow* row : group.rows) {
    if (group.pairs && row->result.accepted()) values.push_back(of(*row));
  }
  return maximum(values);
}

double metres_off(const StemPairRow& row) { return row.deviation.translation_m; }
double degrees_off(const StemPairRow& row) { return rad_to_deg(row.deviation.rotation_rad); }

std::vector<double> pair_times_ms(const StemPairGroup& group) {
  std::vector<double> times_ms;
  for (const StemPairRow* row : group.rows) times_ms.push_back(row->match_ms);
  return times_ms;
}

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json group_json(const StemPairGroup& group) {
  const std::int64_t n = group.size(), wrong = group.accepted() - group.successes();
  const auto part = [&](std::int64_t count) { return static_cast<double>(count) / double(n); };
  const auto wilson = [&](std::int64_t count) {
    const Interval interval = wilson_interval(count, n).value_or(Interval{0.0, 1.0});
    return Json{interval.low, interval.high};
  };
  double stems = 0.0;
  for (const StemPairRow* row : group.rows) stems += static_cast<double>(row->stems_in_map) / n;
  Json row;
  row["case"] = group.pairs ? "pairs" : "wrong combinations";
  row["method"] = group.method;
  row["frames"] = 1;
  row["stems_in_map"] = stems;
  row["queries"] = n;
  row["successes"] = group.successes();
  row["success_rate"] = part(group.successes());
  row["success_interval"] = wilson(group.successes());
  row["accepted"] = group.accepted();
  row["wrong"] = wrong;
  row["wrong_rate"] = part(wrong);
  row["wrong_interval"] = wilson(wrong);
  row["refused_rate"] = part(n - group.accepted());
  row["error_over_bound"] = nullptr;
  row["greatest_deviation_m"] = json_of(greatest(group, metres_off));
  row["greatest_deviation_deg"] = json_of(greatest(group, degrees_off));
  const auto times_ms = pair_times_ms(group);
  row["time_ms"] = {{"p50", json_of(percentile(times_ms, 50))},
                    {"p95", json_of(percentile(times_ms, 95))}};
  return row;
}

Json plot_json(const StemPairRow& row) {
  Json json;
  json["method"] = row.method;
  json["plot"] = row.scan;
  json["stems"] = row.result.stems;
  json["stems_in_map"] = row.stems_in_map;
  json["verdict"] = verdict_name(row.result.verdict);
  json["inliers"] = row.result.inliers;
  json["margin"] = row.result.margin;
  json["deviation_m"] = row.result.accepted() ? Json(metres_off(row)) : Json(nullptr);
  json["deviation_deg"] = row.result.accepted() ? Json(degrees_off(row)) : Json(nullptr);
  return json;
}

SummaryTable json_table(std::vector<Json> rows, const std::vector<std::string>& protocol) {
  SummaryTable table;
  table.rows = std::move(rows);
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  for (const std::string& sentence : protocol) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

std::string text_or_dash(const std::optional<double>& value, int decimals) {
  return value ? fixed(*value, decimals) : "–";
}

ReportTable groups_table(const std::vector<StemPairGroup>& groups) {
  ReportTable table;
  table.title = "Pairs and wrong combinations";
  table.protocol = "one scan, no guess, no setting of its own";
  table.headers = {{"case"},          {"method"}, {"accepted"},           {"right"},
                   {"wrong"},         {"of N"},   {"greatest dev.", "m"}, {"greatest dev.", "deg"},
                   {"time p50", "ms"}};
  for (const StemPairGroup& g : groups) {
    table.rows.push_back({{g.pairs ? "pairs" : "wrong combinations"},
                          {g.method},
                          {fmt::format("{}", g.accepted())},
                          {fmt::format("{}", g.successes())},
                          {fmt::format("{}", g.accepted() - g.successes())},
                          {fmt::format("{}", g.size())},
                          {text_or_dash(greatest(g, metres_off), 3)},
                          {text_or_dash(greatest(g, degrees_off), 3)},
                          {text_or_dash(percentile(pair_times_ms(g), 50), 2)}});
  }
  return table;
}

ReportTable plots_table(const std::vector<StemPairRow>& rows) {
  ReportTable table;
  table.title = "The pairs, plot by plot";
  table.protocol = "deviation from the brute-force answer";
  table.headers = {{"method"},  {"plot"},   {"stems"},          {"stems in map"},    {"verdict"},
                   {"inliers"}, {"margin"}, {"deviation", "m"}, {"deviation", "deg"}};
  for (const StemPairRow& row : rows) {
    if (!row.same_plot) continue;
    const bool accepted = row.result.accepted();
    table.rows.push_back({{row.method},
                          {row.scan},
                          {fmt::format("{}", row.result.stems)},
                          {fmt::format("{}", row.stems_in_map)},
                          {std::string(verdict_name(row.result.verdict))},
                          {fmt::format("{}", row.result.inliers)},
                          {fixed(row.result.margin, 2)},
                          {accepted ? fixed(metres_off(row), 3) : "–"},
                          {accepted ? fixed(degrees_off(row), 3) : "–"}});
  }
  return table;
}

std::vector<std::string> pairs_protocol(const Scenario& scenario) {
  return {fmt::format("Each scan's stem list is asked of each plot's field map, without a guess. "
                      "A pair is right when accepted and within {} m and {}° of the answer of a "
                      "brute-force search over turn and shift; an accepted wrong combination is "
                      "wrong.",
                      scenario.pairs.within_m, scenario.pairs.within_deg),
          "Intervals: Wilson, 95 %. Times: wall time of one query on one thread."};
}

/// The last method's answer to the first plot that it accepts, and to the first wrong combination.
std::vector<ReportFigure> draw_pairs(const std::filesystem::path& folder,
                                     const std::vector<StemPairPlot>& plots,
                                     const std::vector<StemPairRow>& rows) {
  std::vector<ReportFigure> figures;
  const auto plot_of = [&](const std::string& name) {
    return std::find_if(plots.begin(), plots.end(), [&](const auto& p) { return p.name == name; });
  };
  for (const bool pair : {true, false}) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const StemPairRow& r) {
      return r.method == rows.back().method && r.same_plot == pair && r.result.accepted() == pair;
    });
    if (row == rows.end()) continue;
    SightingExhibit exhibit;
    exhibit.name = pair ? "pair_accepted" : "combination_refused";
    exhibit.title =
        fmt::format("{}: scan of {} in the field map of {}", row->method, row->scan, row->map);
    exhibit.verdict = fmt::format("{}; {} stems, {} with a partner, margin {:.2f}",
                                  verdict_name(row->result.verdict), row->result.stems,
                                  row->result.inliers, row->result.margin);
    exhibit.caption =
        "The scan laid onto the map by the answer, accepted or not; blue: a stem of the map "
        "within 0.5 m.";
    exhibit.map_m = plot_of(row->map)->field_m;
    exhibit.T_map_sensor = row->result.T_map_local;
    exhibit.range_m = 20.0;
    for (const Eigen::Vector2d& stem_m : plot_of(row->scan)->scan_m) {
      const Eigen::Vector2d place_m = row->result.T_map_local * stem_m;
      const bool near = std::any_of(exhibit.map_m.begin(), exhibit.map_m.end(),
                                    [&](const auto& m) { return (m - place_m).norm() < 0.5; });
      (near ? exhibit.list_in_map_m : exhibit.felled_or_false_in_map_m).push_back(place_m);
    }
    figures.push_back(draw_sighting_exhibit(folder, exhibit));
  }
  return figures;
}

}  // namespace

RunOutcome run_stem_pairs_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  const auto plots = read_stem_pairs(request.resolved);
  OutputFolder folder(request.out);
  const auto rows = locate_stem_pairs(scenario, plots);
  const auto groups = groups_of_pairs(rows);

  LocalizeResults results;
  results.frames = stem_pair_table(rows);
  results.protocol = pairs_protocol(scenario);
  std::vector<Json> by_group, by_plot;
  for (const StemPairGroup& group : groups) by_group.push_back(group_json(group));
  for (const StemPairRow& row : rows) {
    if (row.same_plot) by_plot.push_back(plot_json(row));
  }
  const std::string name = table_name_of(request.resolved);
  results.tables[name] = json_table(std::move(by_group), results.protocol);
  results.tables[name + "_by_plot"] = json_table(std::move(by_plot), results.protocol);
  results.report_tables = {groups_table(groups), plots_table(rows)};
  results.figures = draw_pairs(folder.path() / "figures", plots, rows);
  return write_localize_results(request, context, folder, std::move(results));
}

}  // namespace honka::eval
