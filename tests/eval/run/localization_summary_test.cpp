#include "eval/run/localization_summary.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "eval/run/localization_row.h"
#include "eval/run/localization_tables.h"

using namespace honka;
using namespace honka::eval;

namespace {

LocalizationRow row_of(const std::string& variant, std::int64_t frames, std::int64_t trial) {
  LocalizationRow row;
  row.variant = variant;
  row.map = "prior_run";
  row.tolerance_m2 = 4.5;
  row.frames = frames;
  row.trial = trial;
  row.verdict = "not_in_map";
  row.translation_error_m = 77.0;  // of an answer that does not count unless accepted
  row.rotation_error_rad = 1.0;
  return row;
}

/// Refused, with so many stems and so long online.
LocalizationRow refused(int stems, double online_ms, std::int64_t trial) {
  LocalizationRow row = row_of("default", 1, trial);
  row.stems = stems;
  row.matches = 1;
  row.match_ms = online_ms;
  return row;
}

LocalizationRow accepted(int stems, double online_ms, std::int64_t trial, double error_m,
                         bool success) {
  LocalizationRow row = refused(stems, 0.25 * online_ms, trial);
  row.aggregate_ms = 0.25 * online_ms;
  row.extract_ms = 0.5 * online_ms;
  row.verdict = "accepted";
  row.accepted = true;
  row.success = success;
  row.matches = 6;
  row.translation_error_m = error_m;
  row.rotation_error_rad = 0.01 * error_m;
  row.error_to_odometry_m = 2.0 * error_m;
  row.bound_m = 0.1;
  return row;
}

/// Five windows on two stands: two found, one found wrong, two refused.
Table five_windows() {
  Table table = localization_table();
  append(table, accepted(40, 1.0, 0, 0.3, true));
  append(table, refused(30, 2.0, 0));
  append(table, accepted(50, 3.0, 0, 90.0, false));
  append(table, accepted(60, 4.0, 1, 0.4, true));
  append(table, refused(20, 5.0, 1));
  return table;
}

Scenario scenario_with(double key_frame_m) {
  Scenario scenario;
  scenario.frame.distance_m = key_frame_m;
  return scenario;
}

}  // namespace

TEST_CASE("rates count refused and wrong windows, errors the successes alone") {
  const auto summaries = summarize(five_windows(), scenario_with(0.3));
  REQUIRE(summaries.size() == 1);
  const LocalizationSummary& s = summaries[0];
  CHECK(s.windows == 5);
  CHECK(s.success_rate() == Approx(0.4));
  CHECK(s.accepted_rate() == Approx(0.6));
  CHECK(s.wrong_rate() == Approx(0.2));
  CHECK(s.trunks == Approx(40.0));
  CHECK(s.matches == Approx((3 * 6 + 2 * 1) / 5.0));
  // Wilson, 2 of 5, z = 1.96
  CHECK(s.success_interval.low == Approx(0.1176).margin(1e-4));
  CHECK(s.success_interval.high == Approx(0.7693).margin(1e-4));
  CHECK(*s.translation_m.mean == Approx(0.35));
  CHECK(*s.translation_m.sd == Approx(std::sqrt(0.005)));
  CHECK(*s.translation_m.max == Approx(0.4));
  CHECK(*s.rotation_deg.max == Approx(0.004 * 180.0 / 3.14159265358979));
  CHECK(*s.to_odometry_m.mean == Approx(0.7));
  // √((0.09 + 0.16) / 2) over 0.1
  CHECK(*s.error_over_bound == Approx(std::sqrt(0.125) / 0.1));
}

TEST_CASE("percentiles of time are those of the sums of the stages, over all windows") {
  const auto s = summarize(five_windows(), scenario_with(0.3)).at(0);
  CHECK(s.online_p50_ms == Approx(3.0));
  CHECK(s.online_p95_ms == Approx(4.8));
  CHECK(s.match_p50_ms == Approx(1.0));
  CHECK(s.extract_p50_ms == Approx(0.5));
  // A key frame every 0.3 m and every 4.8 ms.
  CHECK(s.keeps_up_m_s == Approx(62.5));
}

TEST_CASE("the interval over stands needs two stands") {
  const auto two = summarize(five_windows(), scenario_with(0.3)).at(0);
  REQUIRE(two.stands_interval);
  CHECK(two.stands_interval->low >= 1.0 / 3.0 - 1e-12);
  CHECK(two.stands_interval->high <= 0.5 + 1e-12);
  Table one = localization_table();
  append(one, refused(30, 1.0, 4));
  CHECK_FALSE(summarize(one, scenario_with(0.3)).at(0).stands_interval);
}

TEST_CASE("without a success there are no errors, and JSON says null") {
  Table table = localization_table();
  append(table, refused(30, 1.0, 0));
  append(table, accepted(30, 1.0, 0, 90.0, false));
  const auto summaries = summarize(table, scenario_with(0.3));
  CHECK_FALSE(summaries[0].translation_m.mean);
  CHECK_FALSE(summaries[0].error_over_bound);
  const Json row = localization_json(summaries, Scenario{}).rows.at(0);
  CHECK(row["translation_error_m"]["mean"].is_null());
  CHECK(row["success_rate"] == 0.0);
  CHECK(row["wrong_rate"] == 0.5);
  CHECK(row["refused_rate"] == 0.5);
}

TEST_CASE("a single success has a mean and no s.d.") {
  Table table = localization_table();
  append(table, accepted(30, 1.0, 0, 0.2, true));
  const auto s = summarize(table, scenario_with(0.3)).at(0);
  CHECK(*s.translation_m.mean == Approx(0.2));
  CHECK_FALSE(s.translation_m.sd);
}

TEST_CASE("summaries keep variants together, in the order in which they first appear") {
  Table table = localization_table();
  for (const std::int64_t trial : {0, 1}) {
    for (const std::int64_t frames : {1, 3}) {
      for (const char* variant : {"default", "same_run"})
        append(table, row_of(variant, frames, trial));
    }
  }
  std::vector<std::pair<std::string, std::int64_t>> order;
  for (const auto& s : summarize(table, scenario_with(0.3))) {
    order.emplace_back(s.variant, s.frames);
    CHECK(s.windows == 2);
  }
  CHECK(order == std::vector<std::pair<std::string, std::int64_t>>{
                     {"default", 1}, {"default", 3}, {"same_run", 1}, {"same_run", 3}});
}

TEST_CASE("stems by range are summed over windows, for the chains that differ") {
  Table table = localization_table();
  for (const char* variant : {"default", "tolerance_9", "repaired"}) {
    for (int k = 0; k < 2; ++k) {
      LocalizationRow row = row_of(variant, 3, 0);
      row.detection[1] = {10 + k, 8, 20, 9};
      row.stem_rmse_m = k == 0 ? std::optional<double>() : 0.05;
      append(table, row);
    }
  }
  const auto detection = summarize_detection(table);
  REQUIRE(detection.size() == 2);
  CHECK(detection[0].variant == "default");
  CHECK(detection[1].variant == "repaired");
  const auto& bin = detection[0].bins.at(1);
  CHECK(bin.low_m == 10.0);
  CHECK(bin.high_m == 20.0);
  CHECK(bin.found == 21);
  CHECK(bin.found_true == 16);
  CHECK(bin.trees == 40);
  CHECK(bin.trees_found == 18);
  CHECK(*detection[0].stem_rmse_m == Approx(0.05));
}

TEST_CASE("refused answers are missing in the table, not numbers") {
  const Table table = five_windows();
  for (const char* name : {"x_m", "y_m", "yaw_rad", "translation_error_m", "rotation_error_rad",
                           "error_to_odometry_m"}) {
    CHECK_FALSE(std::isnan(table.doubles(name)[0]));
    CHECK(std::isnan(table.doubles(name)[1]));
    CHECK_FALSE(std::isnan(table.doubles(name)[2]));
  }
}
