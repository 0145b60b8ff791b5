#include "eval/run/odometry_scores.h"

#include <catch2/catch.hpp>

#include "eval/run/odometry_rows.h"
#include "eval/run/odometry_tables.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// 20 s straight on at 1 m/s, 10 sweeps a second; `estimate` gives the estimated pose at a time.
template <class Estimate>
OdometryRun straight_run(const Estimate& estimate) {
  OdometryRun run;
  run.stand = "plain";
  run.odometry = "loam";
  for (int i = 0; i < 200; ++i) {
    const double t = 0.1 * i;
    OdometryEstimate e;
    e.sweep = i;
    e.start_time_s = t;
    e.end_time_s = t + 0.1;
    e.T_odom_start = estimate(t);
    run.estimates.push_back(e);
    run.pairs.poses.push_back({t, pose_from_rpy({t, 0, 0}, 0, 0, 0), e.T_odom_start});
    run.driven_m.push_back(t);
    run.times_ms.push_back(2.0);
  }
  return run;
}

OdometryRun exact_run() {
  return straight_run([](double t) { return pose_from_rpy({t, 0, 0}, 0, 0, 0); });
}

void set_status(OdometryRun& run, std::size_t begin, std::size_t end, OdometryStatus status,
                OdometryCause cause) {
  for (std::size_t i = begin; i < end; ++i) {
    run.estimates[i].status = status;
    run.estimates[i].cause = cause;
  }
}

}  // namespace

TEST_CASE("an exact run has no drift, is never lost, and its time is its sweeps'") {
  const OdometryScores scores = score_odometry(exact_run());
  CHECK(mean_drift(scores.sub_paths)->percent == Approx(0.0).margin(1e-9));
  CHECK(scores.lost.empty());
  CHECK(scores.causes.empty());
  CHECK(scores.sweeps(OdometryStatus::kRegistered) == 200);
  CHECK(scores.driven_m == Approx(19.9));
  CHECK(scores.sensor_s == Approx(20.0));
  CHECK(scores.real_time_factor() == Approx(50.0));
  CHECK(causes_text(scores.causes) == "–");
}

TEST_CASE("unregistered for more than a second is lost, for a second it is not") {
  OdometryRun run = exact_run();
  set_status(run, 10, 20, OdometryStatus::kPredicted, OdometryCause::kFewFeatures);
  CHECK(lost_sequences(run).empty());
  set_status(run, 50, 61, OdometryStatus::kPredicted, OdometryCause::kFewFeatures);
  set_status(run, 50, 54, OdometryStatus::kRefused, OdometryCause::kGap);
  const auto lost = lost_sequences(run);
  REQUIRE(lost.size() == 1);
  CHECK(lost[0].start_s == Approx(5.0));
  CHECK(lost[0].end_s == Approx(6.1));
  CHECK(lost[0].cause == "few_features");
  const OdometryScores scores = score_odometry(run);
  CHECK(causes_text(scores.causes) == "few_features 17, gap 4");
  CHECK(scores.sweeps(OdometryStatus::kRefused) == 4);
}

TEST_CASE("a wrong motion that was not noticed is lost, with its sweeps around it") {
  const OdometryRun jump = straight_run([](double t) {
    return pose_from_rpy({t + (t >= 9.95 ? 1.5 : 0.0), 0, 0}, 0, 0, 0);
  });
  const auto lost = lost_sequences(jump);
  REQUIRE(lost.size() == 1);
  // Motions over 1 s that hold the jump at 10.0 s begin at 9.0 to 9.9 s and end by 10.9 s.
  CHECK(lost[0].start_s == Approx(9.0));
  CHECK(lost[0].end_s == Approx(11.0));
  CHECK(lost[0].cause == "unnoticed");
  const OdometryRun turn = straight_run([](double t) {
    return pose_from_rpy({t, 0, 0}, 0, 0, t >= 9.95 ? deg_to_rad(6.0) : 0.0);
  });
  CHECK(lost_sequences(turn).size() == 1);
  const OdometryRun small = straight_run([](double t) {
    return pose_from_rpy({t + (t >= 9.95 ? 0.9 : 0.0), 0, 0}, 0, 0, 0);
  });
  CHECK(lost_sequences(small).empty());
}

TEST_CASE("an estimate that never moves has figures, not an end of the program") {
  const OdometryScores scores =
      score_odometry(straight_run([](double) { return Pose3::Identity(); }));
  CHECK(mean_drift(scores.sub_paths)->percent == Approx(100.0).epsilon(0.02));
  CHECK(scores.rpe_per_metre.translation_m.empty());
}

TEST_CASE("trials are pooled: sub-paths and sweeps together, sums of time") {
  OdometryScores pooled = score_odometry(exact_run());
  pooled.merge(score_odometry(straight_run([](double t) {
    return pose_from_rpy({1.02 * t, 0, 0}, 0, 0, 0);
  })));
  CHECK(pooled.trials == 2);
  CHECK(mean_drift(pooled.sub_paths)->percent == Approx(1.0));
  CHECK(pooled.real_time_factor() == Approx(50.0));
  CHECK(pooled.sweeps(OdometryStatus::kRegistered) == 400);

  const SummaryTable table = stands_json({pooled});
  REQUIRE(table.rows.size() == 1);
  CHECK(table.columns.size() == table.rows[0].size());
  CHECK(table.rows[0]["drift_percent"] == mean_drift(pooled.sub_paths)->percent);
  CHECK(table.rows[0]["lost"] == 0);
  CHECK(stands_table({pooled}).rows[0][3].text == "1.000");
  for (const ReportTable& shown :
       {stands_table({pooled}), odometry_errors_table({pooled}), odometry_sweeps_table({pooled})}) {
    REQUIRE(shown.rows.size() == 1);
    CHECK(shown.rows[0].size() == shown.headers.size());
  }
  CHECK(lost_table({pooled}).rows.empty());
}

TEST_CASE("rows hold one line a run and one a sweep") {
  const OdometryRun run = exact_run();
  Table trials = odometry_trial_table(), sweeps = odometry_sweep_table();
  append_odometry_trial(trials, 3, score_odometry(run));
  append_odometry_sweeps(sweeps, 0, run);
  CHECK(trials.rows() == 1);
  CHECK(trials.strings("stand")[0] == "plain");
  CHECK(sweeps.rows() == 200);
  CHECK(sweeps.doubles("x_m")[100] == Approx(10.0));
  CHECK_FALSE(sweeps.column("time_ms").in_digest);
}
