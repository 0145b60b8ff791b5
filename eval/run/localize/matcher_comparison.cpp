#include "eval/run/localize/matcher_comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "eval/run/localization_tables.h"

namespace honka::eval {
namespace {

Json value_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

double value_or_nan(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

/// What the error has beyond the bound, as an RMS: with several frames the odometry's share.
std::optional<double> beyond_bound_m(const LocalizationSummary& s) {
  if (!s.in_map_rms_m || !s.in_map_bound_m) return std::nullopt;
  return std::sqrt(
      std::max(0.0, *s.in_map_rms_m * *s.in_map_rms_m - *s.in_map_bound_m * *s.in_map_bound_m));
}

std::string stem_chain_name(const LocalizationSummary& s) {
  return s.repaired ? "repaired" : "Algorithm 1";
}

Json comparison_row(const LocalizationSummary& s) {
  Json row;
  row["method"] = s.method;
  row["map"] = s.map;
  row["chain"] = s.repaired ? "repaired" : "literal";
  row["frames"] = s.frames;
  row["stems_in_map"] = s.stems_in_map;
  row["queries"] = s.windows;
  row["stems"] = s.trunks;
  row["successes"] = s.successes;
  row["success_rate"] = s.success_rate();
  row["success_interval"] = {s.success_interval.low, s.success_interval.high};
  row["wrong"] = s.accepted - s.successes;
  row["wrong_rate"] = s.wrong_rate();
  row["refused_rate"] = 1.0 - s.accepted_rate();
  row["error_over_bound"] = value_or_null(s.in_map_over_bound());
  row["error_over_bound_to_world"] = value_or_null(s.error_over_bound);
  row["rms_error_in_map_m"] = value_or_null(s.in_map_rms_m);
  row["rms_bound_m"] = value_or_null(s.in_map_bound_m);
  row["beyond_bound_m"] = value_or_null(beyond_bound_m(s));
  row["translation_error_m"] = {{"mean", value_or_null(s.translation_m.mean)},
                                {"std", value_or_null(s.translation_m.sd)},
                                {"max", value_or_null(s.translation_m.max)}};
  row["time_ms"] = {{"p50", s.match_p50_ms}, {"p95", s.match_p95_ms}};
  row["online_time_ms"] = {{"p50", s.online_p50_ms}, {"p95", s.online_p95_ms}};
  return row;
}

std::vector<std::string> comparison_protocol(const Scenario& scenario) {
  std::vector<std::string> protocol = localization_protocol(scenario);
  protocol.emplace_back(
      "Matchers side by side are asked the same stems: those of Algorithm 1 as printed, and those "
      "of the repaired chain (height band, unbiased centres), each with the map by its own chain.");
  protocol.emplace_back(
      "Error over bound: RMS distance of the successes from the true place in the map as it lies "
      "there (rigid fit of the trees within 50 m to their stems in the map: what the mapping run's "
      "odometry bent is not the matcher's), over the RMS Cramér-Rao bound of (x, y, yaw), whose σ "
      "is the residual of the listed stems against the map at that place. To the world: without "
      "that fit. Beyond the bound: the root of the difference of squares, with several frames the "
      "share of the odometry that joined them.");
  return protocol;
}

}  // namespace

SummaryTable matcher_comparison_json(const std::vector<LocalizationSummary>& summaries,
                                     const Scenario& scenario) {
  SummaryTable table;
  for (const LocalizationSummary& s : summaries) table.rows.push_back(comparison_row(s));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  for (const std::string& sentence : comparison_protocol(scenario)) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

ReportTable matcher_comparison_table(const std::vector<LocalizationSummary>& summaries,
                                     const Scenario& scenario) {
  ReportTable table;
  table.title = "Matchers side by side";
  table.protocol =
      fmt::format("same stems; success: accepted and within {} m and {}°; time of matching alone",
                  scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg);
  table.headers = {{"method"},
                   {"map"},
                   {"chain"},
                   {"frames"},
                   {"stems"},
                   {"success", "%"},
                   {"95 % interval", "%"},
                   {"n of N"},
                   {"wrong"},
                   {"refused", "%"},
                   {"error / bound"},
                   {"to the world"},
                   {"beyond", "m"},
                   {"time p50 / p95", "ms"}};
  for (const LocalizationSummary& s : summaries) {
    table.rows.push_back({{s.method},
                          {s.map},
                          {stem_chain_name(s)},
                          {fmt::format("{}", s.frames)},
                          {fixed(s.trunks, 1)},
                          {fixed(100.0 * s.success_rate(), 1)},
                          {fmt::format("{:.2f} – {:.2f}", 100.0 * s.success_interval.low,
                                       100.0 * s.success_interval.high)},
                          {fmt::format("{} of {}", s.successes, s.windows)},
                          {fmt::format("{}", s.accepted - s.successes)},
                          {fixed(100.0 * (1.0 - s.accepted_rate()), 1)},
                          {fixed(value_or_nan(s.in_map_over_bound()), 2)},
                          {fixed(value_or_nan(s.error_over_bound), 2)},
                          {fixed(value_or_nan(beyond_bound_m(s)), 3)},
                          {fmt::format("{:.2f} / {:.2f}", s.match_p50_ms, s.match_p95_ms)}});
  }
  return table;
}

}  // namespace honka::eval
