#include "eval/run/localize/sighting_tables.h"

#include <fmt/format.h>

#include <limits>

namespace honka::eval {
namespace {

Json null_or(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

double nan_or(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

Json sighting_row_json(const SightingSummary& s) {
  Json row;
  row["case"] = s.name;
  row["method"] = s.method;
  row["frames"] = 1;
  row["stems_in_map"] = s.stems_in_map;
  row["queries"] = s.queries;
  row["stems"] = s.stems;
  row["true_stems"] = s.true_stems;
  row["successes"] = s.successes;
  row["success_rate"] = s.share(s.successes);
  row["success_interval"] = {s.success_interval.low, s.success_interval.high};
  row["accepted"] = s.accepted;
  row["wrong"] = s.wrong();
  row["wrong_rate"] = s.share(s.wrong());
  row["wrong_interval"] = {s.wrong_interval.low, s.wrong_interval.high};
  row["refused_rate"] = s.share(s.queries - s.accepted);
  row["ambiguous_rate"] = s.share(s.ambiguous);
  row["error_over_bound"] = null_or(s.error_over_bound);
  row["rotation_over_bound"] = null_or(s.rotation_over_bound);
  row["error_over_stated"] = null_or(s.error_over_stated);
  row["rms_error_m"] = null_or(s.rms_error_m);
  row["rms_bound_m"] = null_or(s.rms_bound_m);
  row["time_ms"] = {{"p50", s.time_p50_ms}, {"p95", s.time_p95_ms}};
  row["map_ms"] = s.build_ms;
  row["index_bytes"] = null_or(s.index_bytes);
  row["map_memory_bytes"] = null_or(s.memory_bytes);
  return row;
}

std::string percent_range(const Interval& interval) {
  return fmt::format("{:.2f} – {:.2f}", 100.0 * interval.low, 100.0 * interval.high);
}

std::string mebibytes(const std::optional<double>& bytes) {
  return fixed(nan_or(bytes) / (1024.0 * 1024.0), 1);
}

std::string lists_of(const Scenario& scenario) {
  const auto& d = scenario.sighting.detector;
  return fmt::format("one frame, {:.0f} m, {:.0f}°; success within {} m and {}°{}", d.range_m,
                     d.field_of_view_deg, scenario.protocol.success_translation_m,
                     scenario.protocol.success_rotation_deg,
                     scenario.sighting.elsewhere ? "; lists of another forest" : "");
}

}  // namespace

std::vector<std::string> sighting_protocol(const Scenario& scenario) {
  const SightingStudySettings& s = scenario.sighting;
  std::vector<std::string> protocol = {
      fmt::format("Stem lists without rays, one frame each: trees within {} m and ±{}° of the "
                  "sensor, missed, moved and joined by false ones as the case says; with a limit "
                  "the nearest so many, false ones counted and no farther than the true ones.",
                  s.detector.range_m, 0.5 * s.detector.field_of_view_deg),
      fmt::format("Noise is the s.d. on each axis of a listed stem; mapped stems have {} m of "
                  "their own. The sensor stands anywhere, at least {} m inside the forest, any "
                  "heading; the lists of a case are spread over {} forest(s) of the same kind.",
                  s.map.noise_m, s.border_m, scenario.trials),
      fmt::format("Success: accepted and within {} m and {}° of the truth. Wrong: accepted and "
                  "not. Intervals: Wilson, 95 %. No setting of a matcher follows the case.",
                  scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg),
      "Error over bound: RMS error of the successes over the RMS of the Cramér-Rao bound of (x, y, "
      "yaw) at the sensor, from the listed stems that are in the map and σ² = list + map.",
      "Error over stated: the same over the RMS of the s.d. that the matcher states itself; 1 is "
      "honest. What a matcher states beyond the bound is what it cannot know: which stem is which "
      "tree.",
      "Times are wall times of one query on one thread while all asked threads work: matching "
      "alone. Map time, index and memory: making graph or index on one thread; memory is the peak "
      "of resident pages over those held before."};
  if (s.elsewhere) {
    protocol.push_back(
        "The lists are of another forest, grown with the same settings and another seed: every "
        "accepted answer is wrong.");
  }
  return protocol;
}

SummaryTable sighting_json(const std::vector<SightingSummary>& summaries,
                           const Scenario& scenario) {
  SummaryTable table;
  for (const SightingSummary& s : summaries) table.rows.push_back(sighting_row_json(s));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  for (const std::string& sentence : sighting_protocol(scenario)) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

ReportTable sighting_report_table(const std::vector<SightingSummary>& summaries,
                                  const Scenario& scenario, const std::string& title) {
  ReportTable table;
  table.title = title;
  table.protocol = lists_of(scenario);
  table.headers = {{"case"},
                   {"method"},
                   {"stems in map"},
                   {"stems listed"},
                   {"success", "%"},
                   {"95 % interval", "%"},
                   {"n of N"},
                   {"wrong"},
                   {"95 % up to", "%"},
                   {"ambiguous", "%"},
                   {"refused", "%"},
                   {"error / bound"},
                   {"error / stated"},
                   {"time p50 / p95", "ms"}};
  for (const SightingSummary& s : summaries) {
    table.rows.push_back({{s.name},
                          {s.method},
                          {fmt::format("{}", s.stems_in_map)},
                          {fixed(s.stems, 1)},
                          {fixed(100.0 * s.share(s.successes), 1)},
                          {percent_range(s.success_interval)},
                          {fmt::format("{} of {}", s.successes, s.queries)},
                          {fmt::format("{}", s.wrong())},
                          {fixed(100.0 * s.wrong_interval.high, 2)},
                          {fixed(100.0 * s.share(s.ambiguous), 1)},
                          {fixed(100.0 * s.share(s.queries - s.accepted), 1)},
                          {fixed(nan_or(s.error_over_bound), 2)},
                          {fixed(nan_or(s.error_over_stated), 2)},
                          {fmt::format("{:.2f} / {:.2f}", s.time_p50_ms, s.time_p95_ms)}});
  }
  return table;
}

ReportTable sighting_cost_table(const std::vector<SightingSummary>& summaries) {
  ReportTable table;
  table.title = "What the maps cost";
  table.protocol = "graph or index, one thread; memory beyond what was held before";
  table.headers = {{"case"},           {"method"},         {"stems in map"},
                   {"made in", "s"},   {"index", "MiB"},   {"memory", "MiB"},
                   {"RMS error", "m"}, {"RMS bound", "m"}, {"yaw error / bound"}};
  for (const SightingSummary& s : summaries) {
    table.rows.push_back({{s.name},
                          {s.method},
                          {fmt::format("{}", s.stems_in_map)},
                          {fixed(1e-3 * s.build_ms, 3)},
                          {mebibytes(s.index_bytes)},
                          {mebibytes(s.memory_bytes)},
                          {fixed(nan_or(s.rms_error_m), 4)},
                          {fixed(nan_or(s.rms_bound_m), 4)},
                          {fixed(nan_or(s.rotation_over_bound), 2)}});
  }
  return table;
}

}  // namespace honka::eval
