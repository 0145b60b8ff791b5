#include "eval/run/odometry_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

std::vector<double> drift_lengths() { return DriftSettings{}.lengths_m; }

Drift drift_or_nothing(const OdometryScores& s, std::optional<double> length_m = {}) {
  return mean_drift(s.sub_paths, length_m).value_or(Drift{kNothing, kNothing, 0});
}

std::string rmse_text(const std::vector<double>& errors, int decimals) {
  return fixed(rmse(errors).value_or(kNothing), decimals);
}

ReportTable table_of(const std::string& title, std::vector<ReportHeader> headers) {
  ReportTable table;
  table.title = title;
  table.headers = {{"stand"}, {"odometry"}};
  table.headers.insert(table.headers.end(), headers.begin(), headers.end());
  return table;
}

}  // namespace

std::string causes_text(const std::map<std::string, std::int64_t>& causes) {
  std::vector<std::string> texts;
  for (const auto& [cause, sweeps] : causes) texts.push_back(fmt::format("{} {}", cause, sweeps));
  return texts.empty() ? "–" : fmt::format("{}", fmt::join(texts, ", "));
}

std::vector<std::string> odometry_protocol() {
  const LostLimits limits;
  return {
      fmt::format("Drift: the mean, over all sub-paths of {} m driven that start every metre, of "
                  "the error of the motion over the sub-path divided by its length. The length is "
                  "the way of the machine's joint; swings of the lidar at rest add none.",
                  fmt::join(drift_lengths(), ", ")),
      fmt::format("Lost: greatest runs of sweeps without registration for more than {} s, or in "
                  "which a motion over {} s is wrong by more than {} m or {}°. The cause is the "
                  "most frequent one that the odometry gave for these sweeps.",
                  limits.predicted_s, limits.span_s, limits.translation_m, limits.rotation_deg),
      "RPE: RMSE of the motion over 1 m of the estimate's path, end to end. APE: RMSE over all "
      "sweeps after yaw + translation. Both are what `honka evaluate` says of the .tum files here "
      "(--align yaw --delta 1m).",
      "Real-time factor: seconds of the sensor over seconds of processor time that the odometry "
      "takes on one thread, rays not counted.",
      "The odometries see scans alone; both take the same sweeps of a stand.",
  };
}

ReportTable stands_table(const std::vector<OdometryScores>& scores) {
  ReportTable table = table_of(
      "Odometry by stand",
      {{"driven", "m"}, {"drift", "%"}, {"drift", "deg/m"}, {"real-time factor"}, {"lost"}});
  table.protocol =
      "drift: mean over sub-paths of 10, 20, 50, 100 m; lost: sequences; targets on the default "
      "stand: loam 0.5 %, 0.01 deg/m, none lost, 10 x; stems 50 x";
  for (const OdometryScores& s : scores) {
    const Drift drift = drift_or_nothing(s);
    table.rows.push_back({{s.stand},
                          {s.odometry},
                          {fixed(s.driven_m, 0)},
                          {fixed(drift.percent, 3)},
                          {fixed(drift.deg_per_m, 4)},
                          {fixed(s.real_time_factor(), 1)},
                          {std::to_string(s.lost.size())}});
  }
  return table;
}

ReportTable odometry_errors_table(const std::vector<OdometryScores>& scores) {
  ReportTable table = table_of("Errors", {{"RPE per metre", "m"},
                                          {"RPE per metre", "deg"},
                                          {"APE", "m"},
                                          {"APE greatest", "m"},
                                          {"APE", "deg"}});
  for (const double length_m : drift_lengths()) {
    table.headers.push_back({fmt::format("drift over {} m", length_m), "%"});
  }
  for (const OdometryScores& s : scores) {
    std::vector<ReportCell> row = {{s.stand},
                                   {s.odometry},
                                   {rmse_text(s.rpe_per_metre.translation_m, 3)},
                                   {rmse_text(s.rpe_per_metre.rotation_deg, 3)},
                                   {rmse_text(s.ape.translation_m, 3)},
                                   {fixed(maximum(s.ape.translation_m).value_or(kNothing), 3)},
                                   {rmse_text(s.ape.rotation_deg, 3)}};
    for (const double length_m : drift_lengths()) {
      row.push_back({fixed(drift_or_nothing(s, length_m).percent, 3)});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable odometry_sweeps_table(const std::vector<OdometryScores>& scores) {
  ReportTable table = table_of("Sweeps", {{"registered"},
                                          {"degenerate"},
                                          {"predicted"},
                                          {"refused"},
                                          {"causes"},
                                          {"time p50 / p95 / greatest", "ms"}});
  for (const OdometryScores& s : scores) {
    const auto time = [&](double percent) {
      return fixed(percentile(s.times_ms, percent).value_or(kNothing), 1);
    };
    table.rows.push_back({{s.stand},
                          {s.odometry},
                          {std::to_string(s.sweeps(OdometryStatus::kRegistered))},
                          {std::to_string(s.sweeps(OdometryStatus::kDegenerate))},
                          {std::to_string(s.sweeps(OdometryStatus::kPredicted))},
                          {std::to_string(s.sweeps(OdometryStatus::kRefused))},
                          {causes_text(s.causes)},
                          {time(50) + " / " + time(95) + " / " + time(100)}});
  }
  return table;
}

ReportTable lost_table(const std::vector<OdometryScores>& scores) {
  ReportTable table = table_of("Lost sequences", {{"from", "s"}, {"to", "s"}, {"cause"}});
  for (const OdometryScores& s : scores) {
    for (const LostSequence& lost : s.lost) {
      table.rows.push_back({{s.stand},
                            {s.odometry},
                            {fixed(lost.start_s, 1)},
                            {fixed(lost.end_s, 1)},
                            {lost.cause}});
    }
  }
  if (table.rows.empty()) table.notes.push_back("None.");
  return table;
}

}  // namespace honka::eval
