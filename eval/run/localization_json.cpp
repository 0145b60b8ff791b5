#include <fmt/format.h>

#include "eval/run/localization_tables.h"
#include "eval/run/paper_li2020.h"

namespace honka::eval {
namespace {

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json errors(const ErrorStatistics& statistics) {
  return {{"mean", or_null(statistics.mean)},
          {"std", or_null(statistics.sd)},
          {"max", or_null(statistics.max)}};
}

Json paper_json(std::int64_t frames) {
  const auto paper = paper_row(frames);
  if (!paper) return nullptr;
  Json json = {{"trunks", paper->trunks},
               {"matching_triangles", paper->matching_triangles},
               {"success_rate", paper->success_rate},
               {"translation_error_m",
                {{"mean", kPaperTranslationMean_m},
                 {"std", kPaperTranslationSd_m},
                 {"max", kPaperTranslationMax_m}}}};
  if (paper->time_s) json["time_ms"] = 1e3 * *paper->time_s;
  if (paper->max_rotation_deg) json["rotation_error_deg"] = {{"max", *paper->max_rotation_deg}};
  return json;
}

Json row_json(const LocalizationSummary& s) {
  Json row;
  row["frames"] = s.frames;
  row["map"] = s.map;
  row["variant"] = s.variant;
  row["tolerance_m2"] = s.tolerance_m2;
  row["windows"] = s.windows;
  row["trunks"] = s.trunks;
  row["matching_triangles"] = s.matches;
  row["accepted_rate"] = s.accepted_rate();
  row["success_rate"] = s.success_rate();
  row["success_interval"] = {s.success_interval.low, s.success_interval.high};
  row["success_interval_over_stands"] =
      s.stands_interval ? Json{s.stands_interval->low, s.stands_interval->high} : Json(nullptr);
  row["wrong_rate"] = s.wrong_rate();
  row["refused_rate"] = 1.0 - s.accepted_rate();
  row["translation_error_m"] = errors(s.translation_m);
  row["rotation_error_deg"] = errors(s.rotation_deg);
  row["error_to_odometry_m"] = errors(s.to_odometry_m);
  row["error_over_bound"] = or_null(s.error_over_bound);
  row["local_stars"] = s.local_stars;
  row["surviving_stars"] = s.surviving;
  row["time_ms"] = {{"p50", s.online_p50_ms}, {"p95", s.online_p95_ms}};
  row["match_time_ms"] = {{"p50", s.match_p50_ms}, {"p95", s.match_p95_ms}};
  row["keeps_up_m_s"] = s.keeps_up_m_s;
  row["paper"] = paper_json(s.frames);
  return row;
}

}  // namespace

SummaryTable localization_json(const std::vector<LocalizationSummary>& summaries,
                               const Scenario& scenario) {
  SummaryTable table;
  for (const LocalizationSummary& summary : summaries) table.rows.push_back(row_json(summary));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  for (const std::int64_t frames : scenario.protocol.frames) {
    table.paper[std::to_string(frames)] = paper_json(frames);
  }
  for (const std::string& sentence : localization_protocol(scenario)) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

}  // namespace honka::eval
