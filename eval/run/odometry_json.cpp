#include <fmt/format.h>
#include <fmt/ranges.h>

#include "eval/metrics/statistics.h"
#include "eval/run/odometry_tables.h"

namespace honka::eval {
namespace {

Json number_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json drift_by_length(const OdometryScores& s) {
  Json list = Json::array();
  for (const double length_m : DriftSettings{}.lengths_m) {
    const auto drift = mean_drift(s.sub_paths, length_m);
    if (!drift) continue;
    list.push_back({{"length_m", length_m},
                    {"percent", drift->percent},
                    {"deg_per_m", drift->deg_per_m},
                    {"sub_paths", drift->sub_paths}});
  }
  return list;
}

Json lost_list(const OdometryScores& s) {
  Json list = Json::array();
  for (const LostSequence& lost : s.lost) {
    list.push_back({{"start_s", lost.start_s}, {"end_s", lost.end_s}, {"cause", lost.cause}});
  }
  return list;
}

Json stand_row(const OdometryScores& s) {
  const auto drift = mean_drift(s.sub_paths);
  Json row;
  row["stand"] = s.stand;
  row["odometry"] = s.odometry;
  row["drift_percent"] = drift ? Json(drift->percent) : Json();
  row["drift_deg_per_m"] = drift ? Json(drift->deg_per_m) : Json();
  row["real_time_factor"] = s.real_time_factor();
  row["lost"] = s.lost.size();
  row["lost_sequences"] = lost_list(s);
  row["driven_m"] = s.driven_m;
  row["sub_paths"] = s.sub_paths.size();
  row["drift_by_length"] = drift_by_length(s);
  row["rpe_per_metre"] = {{"translation_m", number_or_null(rmse(s.rpe_per_metre.translation_m))},
                          {"rotation_deg", number_or_null(rmse(s.rpe_per_metre.rotation_deg))}};
  row["ape"] = {{"translation_m", number_or_null(rmse(s.ape.translation_m))},
                {"translation_max_m", number_or_null(maximum(s.ape.translation_m))},
                {"rotation_deg", number_or_null(rmse(s.ape.rotation_deg))}};
  row["sweeps"] = {{"registered", s.sweeps(OdometryStatus::kRegistered)},
                   {"degenerate", s.sweeps(OdometryStatus::kDegenerate)},
                   {"predicted", s.sweeps(OdometryStatus::kPredicted)},
                   {"refused", s.sweeps(OdometryStatus::kRefused)}};
  row["causes"] = Json::object();
  for (const auto& [cause, sweeps] : s.causes) row["causes"][cause] = sweeps;
  row["time_ms"] = {{"p50", number_or_null(percentile(s.times_ms, 50))},
                    {"p95", number_or_null(percentile(s.times_ms, 95))}};
  return row;
}

}  // namespace

SummaryTable stands_json(const std::vector<OdometryScores>& scores) {
  SummaryTable table;
  for (const OdometryScores& s : scores) table.rows.push_back(stand_row(s));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  table.protocol = fmt::format("{}", fmt::join(odometry_protocol(), " "));
  return table;
}

}  // namespace honka::eval
