#include "eval/run/localize/map_update_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace honka::eval {
namespace {

Json null_where_missing(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json interval_json(const Interval& interval) { return {interval.low, interval.high}; }

std::string interval_text(const Interval& interval) {
  return fmt::format("{:.1f} – {:.1f}", 100.0 * interval.low, 100.0 * interval.high);
}

Json summary_row(const MapUpdateSummary& s) {
  Json row;
  row["thinned_to_per_ha"] = s.thinned_to_per_ha;
  row["felled_share"] = s.felled_share;
  row["method"] = s.method;
  row["map"] = s.map;
  row["fed_by"] = s.fed_by.empty() ? Json(nullptr) : Json(s.fed_by);
  row["part"] = s.part == 0 ? Json("whole") : Json(s.part);
  row["frames"] = 1;
  row["stems_in_map"] = s.stems_in_map;
  row["queries"] = s.queries;
  row["successes"] = s.successes;
  row["success_rate"] = s.share(s.successes);
  row["success_interval"] = interval_json(s.success_interval);
  row["wrong"] = s.wrong();
  row["wrong_rate"] = s.share(s.wrong());
  row["wrong_interval"] = interval_json(s.wrong_interval);
  row["refused_rate"] = s.share(s.queries - s.accepted);
  row["position_rmse_m"] = null_where_missing(s.rmse_m);
  row["time_ms"] = {{"p50", s.time_p50_ms}, {"p95", s.time_p95_ms}};
  return row;
}

/// n of N as its parts, rate and interval.
void put_share(Json& row, const std::string& name, std::int64_t count, std::int64_t of) {
  const auto interval = wilson_interval(count, of);
  row[name] = {{"n", count},
               {"of", of},
               {"rate", of == 0 ? Json(nullptr)
                                : Json(static_cast<double>(count) / static_cast<double>(of))},
               {"interval", interval ? interval_json(*interval) : Json(nullptr)}};
}

Json quality_row(const MapQualitySummary& s) {
  const MapQuality& q = s.sum;
  Json row;
  row["thinned_to_per_ha"] = s.thinned_to_per_ha;
  row["fed_by"] = q.fed_by;
  row["part"] = q.part;
  row["drives"] = s.drives;
  row["lists"] = q.lists;
  row["accepted"] = q.accepted;
  row["counted"] = q.counted;
  row["stems_in_map"] = static_cast<double>(q.stems_in_map) / static_cast<double>(s.drives);
  put_share(row, "felled_retired", q.felled_retired, q.felled);
  put_share(row, "standing_retired", q.standing_retired, q.standing);
  put_share(row, "unmapped_added", q.unmapped_added, q.unmapped);
  put_share(row, "falsely_added", q.falsely_added, q.added);
  put_share(row, "precision", q.seen_true, q.seen_stems);
  put_share(row, "recall", q.seen_trees_mapped, q.seen_trees);
  row["position_rmse_m"] = null_where_missing(rmse(q.errors_m));
  row["added_rmse_m"] = null_where_missing(rmse(q.added_errors_m));
  row["update_ms"] = q.update_ms;
  return row;
}

template <class Summaries, class ToRow>
SummaryTable table_of_rows(const Summaries& summaries, const Scenario& scenario,
                           const ToRow& to_row) {
  SummaryTable table;
  for (const auto& s : summaries) table.rows.push_back(to_row(s));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  table.protocol = fmt::format("{}", fmt::join(map_update_protocol(scenario), " "));
  return table;
}

std::string share_text(std::int64_t count, std::int64_t of) {
  if (of == 0) return "–";
  return fmt::format("{:.1f} ({} of {})",
                     100.0 * static_cast<double>(count) / static_cast<double>(of), count, of);
}

}  // namespace

SummaryTable map_update_json(const std::vector<MapUpdateSummary>& summaries,
                             const Scenario& scenario) {
  return table_of_rows(summaries, scenario, summary_row);
}

SummaryTable map_quality_json(const std::vector<MapQualitySummary>& summaries,
                              const Scenario& scenario) {
  return table_of_rows(summaries, scenario, quality_row);
}

ReportTable map_update_table(const std::vector<MapUpdateSummary>& summaries,
                             const Scenario& scenario) {
  ReportTable table;
  table.title = "Found, refused and wrong, by map";
  table.protocol = fmt::format(
      "the same lists in every map; success: accepted and within {} m and {}°; Q1 to Q{}: success "
      "in each quarter of the drive",
      scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg, kDriveParts);
  table.headers = {{"thinned to", "1/ha"}, {"method"},    {"map"},       {"map stems"},
                   {"success", "%"},       {"95 %", "%"}, {"n of N"},    {"wrong"},
                   {"refused", "%"},       {"RMSE", "m"}, {"p50", "ms"}, {"p95", "ms"}};
  for (std::int64_t part = 1; part <= kDriveParts; ++part) {
    table.headers.push_back({fmt::format("Q{}", part), "%"});
  }
  for (const MapUpdateSummary& s : summaries) {
    const ReportCell rate{fixed(100.0 * s.share(s.successes), 1)};
    if (s.part != 0) {
      table.rows.back().push_back(rate);
      continue;
    }
    table.rows.push_back({{fixed(s.thinned_to_per_ha, 0)},
                          {s.method},
                          {s.map_name()},
                          {fixed(s.stems_in_map, 0)},
                          rate,
                          {interval_text(s.success_interval)},
                          {fmt::format("{} of {}", s.successes, s.queries)},
                          {fmt::format("{}", s.wrong())},
                          {fixed(100.0 * s.share(s.queries - s.accepted), 1)},
                          {fixed(s.rmse_m.value_or(NAN), 3)},
                          {fixed(s.time_p50_ms, 2)},
                          {fixed(s.time_p95_ms, 2)}});
  }
  const std::size_t width = table.headers.size();
  for (auto& row : table.rows) row.resize(width, {"–"});
  return table;
}

ReportTable map_quality_table(const std::vector<MapQualitySummary>& summaries,
                              const Scenario& scenario) {
  ReportTable table;
  table.title = "The map against the trees that stand";
  table.protocol = fmt::format(
      "within the area seen so far ({} m and {}° about a list; before: by the whole drive); a stem "
      "belongs to a tree within {} m; % and n of N over {} drive(s)",
      scenario.map_update.updater.range_m, scenario.map_update.updater.field_of_view_deg,
      scenario.protocol.stem_gate_m, scenario.trials);
  table.headers = {{"thinned to", "1/ha"},
                   {"fed by"},
                   {"after"},
                   {"accepted lists"},
                   {"felled retired", "%"},
                   {"standing retired", "%"},
                   {"unmapped added", "%"},
                   {"falsely added", "% of added"},
                   {"precision", "%"},
                   {"recall", "%"},
                   {"RMSE", "m"},
                   {"of added", "m"},
                   {"an update", "ms"}};
  for (const MapQualitySummary& s : summaries) {
    const MapQuality& q = s.sum;
    table.rows.push_back({{fixed(s.thinned_to_per_ha, 0)},
                          {q.fed_by},
                          {q.part == 0 ? "before" : fmt::format("Q{}", q.part)},
                          {fmt::format("{} of {}", q.accepted, q.lists)},
                          {share_text(q.felled_retired, q.felled)},
                          {share_text(q.standing_retired, q.standing)},
                          {share_text(q.unmapped_added, q.unmapped)},
                          {share_text(q.falsely_added, q.added)},
                          {share_text(q.seen_true, q.seen_stems)},
                          {share_text(q.seen_trees_mapped, q.seen_trees)},
                          {fixed(rmse(q.errors_m).value_or(NAN), 3)},
                          {fixed(rmse(q.added_errors_m).value_or(NAN), 3)},
                          {fixed(q.update_ms, 1)}});
  }
  return table;
}

std::vector<std::string> map_update_protocol(const Scenario& scenario) {
  const MapUpdateStudySettings& s = scenario.map_update;
  const sim::InventorySettings& inventory = scenario.map.sources.inventory;
  return {
      fmt::format("The old map is a list of trees (map.source = {}) of the stand before the "
                  "thinning: position error {} m, {} % of the stems missed, none thinner than {} "
                  "m. Then strip roads are cut every {} m and the smallest and most crowded trees "
                  "fall until the density is left.",
                  scenario.map.source, inventory.position_error_m, 100.0 * inventory.missed_share,
                  inventory.least_dbh_m, s.strip_road_spacing_m),
      fmt::format("The machine drives all strip roads {} time(s), each pass back along the one "
                  "before, and lists stems every {} m: within {} m and {}°, noise {} m, {} % "
                  "missed, {} % false.",
                  s.passes, s.view_every_m, s.list.range_m, s.list.field_of_view_deg,
                  s.list.noise_m, 100.0 * s.list.missed_share, 100.0 * s.list.false_share),
      fmt::format("Every list is asked, without a guess, in the old map, in the map as updated so "
                  "far, and in a new map: every standing tree and no other, with the old map's "
                  "errors of position. A map is updated every {} lists by the poses that one "
                  "matcher accepted in it, right or wrong; no truth enters.",
                  s.update_every),
      fmt::format("Success: accepted and within {} m and {}°; wrong: accepted and not. Intervals: "
                  "Wilson, 95 %, widened by how much the lists of one road agree.",
                  scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg),
      "Times are wall times of one query on one thread, matching alone; an update: counting the "
      "views since the last one, the decision on every stem, and every matcher made anew."};
}

}  // namespace honka::eval
