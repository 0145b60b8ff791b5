#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "eval/run/slam/link_tables.h"

namespace honka::eval {
namespace {

struct LinkFigureName {
  const char* name;
  double (*of)(const LinkRow&);
};

const LinkFigureName kLinkFigures[] = {
    {"sent_bytes_per_m", [](const LinkRow& r) { return r.sent_bytes_per_m(); }},
    {"key_frames", [](const LinkRow& r) { return double(r.tally.edge.offered); }},
    {"sent", [](const LinkRow& r) { return double(r.tally.edge.sent); }},
    {"queue_full", [](const LinkRow& r) { return double(r.tally.queue_full); }},
    {"lost_on_air", [](const LinkRow& r) { return double(r.tally.lost_on_air); }},
    {"arrived", [](const LinkRow& r) { return double(r.tally.arrived); }},
    {"late", [](const LinkRow& r) { return double(r.tally.late); }},
    {"age_p50_s", [](const LinkRow& r) { return r.tally.age_p50_s; }},
    {"age_p95_s", [](const LinkRow& r) { return r.tally.age_p95_s; }},
    {"behind_m", [](const LinkRow& r) { return r.tally.behind_m; }},
    {"blur", [](const LinkRow& r) { return r.quality.blur; }},
    {"blur_floor", [](const LinkRow& r) { return r.floor.blur; }},
    {"cluster_rmse_m", [](const LinkRow& r) { return r.quality.cluster_rmse_m; }},
    {"cluster_rmse_floor_m", [](const LinkRow& r) { return r.floor.cluster_rmse_m; }},
    {"ate_m", [](const LinkRow& r) { return r.quality.ate_m; }},
    {"ate_planar_m", [](const LinkRow& r) { return r.quality.ate_planar_m; }},
    {"stems_mapped", [](const LinkRow& r) { return double(r.quality.stems_mapped); }},
    {"stems_mapped_floor", [](const LinkRow& r) { return double(r.floor.stems_mapped); }},
    {"stems_false", [](const LinkRow& r) { return double(r.quality.stems_false); }},
    {"stem_rmse_m", [](const LinkRow& r) { return r.quality.stem_rmse_m; }},
};

Json number_or_nothing(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json link_json_row(const LinkScores& s) {
  Json row;
  row["series"] = s.link.series;
  row["variant"] = s.link.variant;
  row["value"] = s.link.value;
  row["bandwidth_bytes_per_s"] =
      s.mean_of([](const LinkRow& r) { return r.link.radio.bandwidth_bytes_per_s; });
  row["method"] = s.method;
  row["trials"] = s.trials.size();
  row["mapped"] = s.mapped();
  for (const LinkFigureName& figure : kLinkFigures) {
    row[figure.name] = number_or_nothing(s.mean_of(figure.of));
    const auto interval = s.interval_of(figure.of);
    if (interval) row[std::string(figure.name) + "_interval"] = {interval->low, interval->high};
  }
  return row;
}

SummaryTable with_columns(SummaryTable table) {
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  table.protocol = fmt::format("{}", fmt::join(link_protocol(), " "));
  return table;
}

}  // namespace

SummaryTable link_series_json(const std::string& series, const std::vector<LinkScores>& scores) {
  SummaryTable table;
  for (const LinkScores& s : scores) {
    if (s.link.series == series) table.rows.push_back(link_json_row(s));
  }
  return with_columns(std::move(table));
}

SummaryTable link_need_json(const std::vector<LinkTrial>& trials) {
  SummaryTable table;
  for (std::size_t trial = 0; trial < trials.size(); ++trial) {
    const LinkNeed& need = trials[trial].need;
    Json row;
    row["trial"] = trial;
    row["key_frames"] = need.key_frames;
    row["stems"] = need.stems;
    row["duration_s"] = need.duration_s;
    row["length_m"] = need.length_m;
    row["raw_bytes_per_m"] = need.raw_bytes / need.length_m;
    row["message_bytes_per_m"] = need.message_bytes / need.length_m;
    row["air_bytes_per_m"] = need.air_bytes / need.length_m;
    row["air_bytes_per_s"] = need.bytes_per_s();
    table.rows.push_back(std::move(row));
  }
  table.paper = {{"raw_bytes_per_m", 28e6}};
  return with_columns(std::move(table));
}

}  // namespace honka::eval
