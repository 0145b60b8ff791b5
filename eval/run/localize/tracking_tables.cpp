#include <fmt/format.h>

#include <cmath>

#include "eval/run/localize/tracking_rows.h"

namespace honka::eval {
namespace {

double tracking_or_nan(const std::optional<double>& value) { return value.value_or(NAN); }

Json tracking_or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

ReportCell tracking_cell(const std::optional<double>& value, int decimals) {
  return {fixed(tracking_or_nan(value), decimals)};
}

ReportCell tracking_count(std::int64_t n) { return {std::to_string(n)}; }

std::string tracking_label(const TrackingRow& row) {
  return fmt::format("{}, C{}{}", row.method, row.frames, row.with_prior ? ", prior" : "");
}

ReportTable accuracy_table(const std::vector<TrackingRow>& rows) {
  ReportTable table;
  table.title = "Track, fixes and odometry";
  table.protocol = "position errors to the truth, RMSE over scans; kidnapping to its report apart";
  table.headers = {{"trial"},
                   {"matcher"},
                   {"scans with a pose", "%"},
                   {"track", "m"},
                   {"largest", "m"},
                   {"right fixes", "m"},
                   {"odometry alone", "m"},
                   {"NEES (3)"},
                   {"below 95 % (0.95)"},
                   {"NEES tracking"},
                   {"coasting"},
                   {"stretches"}};
  for (const TrackingRow& row : rows) {
    table.rows.push_back({tracking_count(row.trial),
                          {tracking_label(row)},
                          {fixed(100.0 * row.with_pose_share, 1)},
                          tracking_cell(row.track_rmse_m, 3),
                          tracking_cell(row.track_max_m, 2),
                          tracking_cell(row.fix_rmse_m, 3),
                          tracking_cell(row.odometry_rmse_m, 3),
                          tracking_cell(row.nees_mean, 2),
                          tracking_cell(row.nees_inside, 3),
                          tracking_cell(row.nees_tracking, 2),
                          tracking_cell(row.nees_coasting, 2),
                          tracking_count(row.stretches)});
  }
  return table;
}

std::vector<ReportHeader> events_headers() {
  return {{"trial"},
          {"matcher"},
          {"first pose", "s"},
          {"kidnapping seen after", "s"},
          {"recovered after", "s"},
          {"false kidnappings"},
          {"losses"},
          {"longest coast", "s"},
          {"ended at", "s"},
          {"its error", "m"},
          {"stated s.d.", "m"},
          {"localizations"},
          {"accepted"},
          {"wrong"},
          {"wrong, taken"},
          {"time p50", "ms"},
          {"p95", "ms"}};
}

ReportTable events_table(const std::vector<TrackingRow>& rows) {
  ReportTable table;
  table.title = "Events and localizations";
  table.headers = events_headers();
  for (const TrackingRow& row : rows) {
    table.rows.push_back({tracking_count(row.trial),
                          {tracking_label(row)},
                          tracking_cell(row.first_pose_s, 1),
                          tracking_cell(row.detect_s, 1),
                          tracking_cell(row.recover_s, 1),
                          tracking_count(row.false_kidnappings),
                          tracking_count(row.losses),
                          tracking_cell(row.longest_coast_s, 1),
                          tracking_cell(row.coast_end_s, 1),
                          tracking_cell(row.coast_error_m, 3),
                          tracking_cell(row.coast_sigma_m, 3),
                          tracking_count(row.localizations),
                          tracking_count(row.accepted),
                          tracking_count(row.wrong_accepted),
                          tracking_count(row.wrong_used),
                          {fixed(row.time_p50_ms, 2)},
                          {fixed(row.time_p95_ms, 2)}});
  }
  return table;
}

Json tracking_json_row(const TrackingRow& row) {
  return {{"trial", row.trial},
          {"method", row.method},
          {"frames", row.frames},
          {"with_prior", row.with_prior},
          {"scans", row.scans},
          {"with_pose_share", row.with_pose_share},
          {"track_rmse_m", tracking_or_null(row.track_rmse_m)},
          {"track_max_m", tracking_or_null(row.track_max_m)},
          {"fix_rmse_m", tracking_or_null(row.fix_rmse_m)},
          {"odometry_rmse_m", tracking_or_null(row.odometry_rmse_m)},
          {"nees_mean", tracking_or_null(row.nees_mean)},
          {"nees_inside_share", tracking_or_null(row.nees_inside)},
          {"nees_tracking", tracking_or_null(row.nees_tracking)},
          {"nees_coasting", tracking_or_null(row.nees_coasting)},
          {"nees_stretches", row.stretches},
          {"first_pose_s", tracking_or_null(row.first_pose_s)},
          {"detect_s", tracking_or_null(row.detect_s)},
          {"recover_s", tracking_or_null(row.recover_s)},
          {"false_kidnappings", row.false_kidnappings},
          {"losses", row.losses},
          {"longest_coast_s", tracking_or_null(row.longest_coast_s)},
          {"coast_end_s", tracking_or_null(row.coast_end_s)},
          {"coast_error_m", tracking_or_null(row.coast_error_m)},
          {"coast_sigma_m", tracking_or_null(row.coast_sigma_m)},
          {"localizations", row.localizations},
          {"accepted", row.accepted},
          {"wrong_accepted", row.wrong_accepted},
          {"wrong_used", row.wrong_used},
          {"time_ms", {{"p50", row.time_p50_ms}, {"p95", row.time_p95_ms}}}};
}

}  // namespace

Table tracking_trial_table(const std::vector<TrackingRow>& rows) {
  using Doubles = std::vector<double>;
  using Ints = std::vector<std::int64_t>;
  Table table({{"trial", "", "trial", Ints{}},
               {"method", "", "matcher", std::vector<std::string>{}},
               {"frames", "", "key frames in a localization", Ints{}},
               {"with_prior", "", "localizations near the track alone", Ints{}},
               {"scans", "", "of the drive", Ints{}},
               {"localizations", "", "asked", Ints{}},
               {"accepted", "", "of them", Ints{}},
               {"wrong_accepted", "", "of them off the truth", Ints{}},
               {"wrong_used", "", "of them taken by the track", Ints{}},
               {"false_kidnappings", "", "reported without one", Ints{}},
               {"losses", "", "of the track", Ints{}},
               {"with_pose_share", "", "scans with a pose", Doubles{}},
               {"track_rmse_m", "m", "position error of the track", Doubles{}},
               {"track_max_m", "m", "largest of them", Doubles{}},
               {"fix_rmse_m", "m", "position error of right localizations", Doubles{}},
               {"odometry_rmse_m", "m", "position error of the odometry alone", Doubles{}},
               {"nees_mean", "", "normalized error squared, 3 degrees of freedom", Doubles{}},
               {"nees_inside_share", "", "below the 95 % quantile", Doubles{}},
               {"nees_tracking", "", "its mean while tracking", Doubles{}},
               {"nees_coasting", "", "and while coasting", Doubles{}},
               {"detect_s", "s", "from the kidnapping to its report", Doubles{}},
               {"recover_s", "s", "from the kidnapping to the next pose", Doubles{}},
               {"time_p50_ms", "ms", "of a localization", Doubles{}, false}});
  for (const TrackingRow& r : rows) {
    table.add_row(r.trial, r.method, r.frames, r.with_prior, r.scans, r.localizations, r.accepted,
                  r.wrong_accepted, r.wrong_used, r.false_kidnappings, r.losses, r.with_pose_share,
                  tracking_or_nan(r.track_rmse_m), tracking_or_nan(r.track_max_m),
                  tracking_or_nan(r.fix_rmse_m), tracking_or_nan(r.odometry_rmse_m),
                  tracking_or_nan(r.nees_mean), tracking_or_nan(r.nees_inside),
                  tracking_or_nan(r.nees_tracking), tracking_or_nan(r.nees_coasting),
                  tracking_or_nan(r.detect_s), tracking_or_nan(r.recover_s), r.time_p50_ms);
  }
  return table;
}

SummaryTable tracking_json(const std::vector<TrackingRow>& rows, const Scenario& scenario) {
  SummaryTable table;
  for (const TrackingRow& row : rows) table.rows.push_back(tracking_json_row(row));
  if (!table.rows.empty()) {
    for (const auto& item : table.rows.front().items()) table.columns.push_back(item.key());
  }
  for (const std::string& sentence : tracking_protocol(scenario)) {
    table.protocol += (table.protocol.empty() ? "" : " ") + sentence;
  }
  return table;
}

std::vector<ReportTable> tracking_tables(const std::vector<TrackingRow>& rows) {
  return {accuracy_table(rows), events_table(rows)};
}

std::vector<std::string> tracking_protocol(const Scenario& scenario) {
  const TrackingStudySettings& s = scenario.tracking;
  return {
      fmt::format("A localization of one frame every {} m of the odometry's way; its answer comes "
                  "one scan later. A pose is asked of the track at every scan.",
                  s.localize_every_m),
      fmt::format("The map is of source {}; it has no stems within {} m of the stretch from {} to "
                  "{} m of the first drive.",
                  scenario.map.source, s.unmapped_margin_m, s.unmapped_from_m,
                  s.unmapped_from_m + s.unmapped_length_m),
      "At the end of the first drive the machine is set down at the start of the second; its "
      "odometry notices nothing.",
      fmt::format("Wrong: accepted, and off the truth by more than {} m or {}°.",
                  scenario.protocol.success_translation_m, scenario.protocol.success_rotation_deg),
      fmt::format("A kidnapping is reported when {} fixes outside the gate of {} agree with one "
                  "another: of independent fixes of the stated covariance a false alarm has "
                  "probability {:.0e} at each fix.",
                  s.filter.confirm_fixes, s.filter.gate_probability,
                  s.filter.false_alarm_probability()),
      fmt::format(
          "NEES: error of (x, y, yaw) weighed by the track's covariance, over all scans with "
          "a pose; its mean is 3 where the covariance is honest. Scans of {} m share an "
          "error: stretches tells of how many ways of that length the mean is.",
          s.filter.shared_length_m)};
}

}  // namespace honka::eval
