// One trial of the SLAM experiment on drives made by hand, whose answers are known on paper.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/types/random.h"
#include "eval/run/slam/slam_rows.h"
#include "eval/run/slam/slam_tables.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// Stems strewn over the plane, seen from a way along an arc with noise; no lidar, no forest.
SlamDrive drive_by_hand(std::size_t frames, double noise_m) {
  SlamDrive drive;
  RandomStream world(7, "hand_stems");
  // One in each cell of 4 m, at least 1.6 m apart: no cluster joins two of them.
  for (double x = -40.0; x < 50.0; x += 4.0) {
    for (double y = -40.0; y < 40.0; y += 4.0) {
      const double at_x = x + world.uniform(-1.2, 1.2), at_y = y + world.uniform(-1.2, 1.2);
      drive.true_stems_in_first_m.emplace_back(at_x, at_y, 0.0);
    }
  }
  const ViewCone cone;
  for (std::size_t l = 0; l < frames; ++l) {
    const double s = 0.25 * static_cast<double>(l);
    const Pose3 T_first_frame = pose_from_rpy({s, 0.02 * s * s, 0.0}, 0.0, 0.0, 0.04 * s);
    RandomStream noise(7, "hand_noise", {l});
    SparseFrame frame;
    frame.number = static_cast<std::int64_t>(l);
    for (const Eigen::Vector3d& stem : drive.true_stems_in_first_m) {
      const Eigen::Vector3d seen = T_first_frame.inverse() * stem;
      if (!cone.holds(Eigen::Vector2d(seen.head<2>()))) continue;
      frame.points_m.emplace_back(
          seen + Eigen::Vector3d(noise.normal(0.0, noise_m), noise.normal(0.0, noise_m), 0.0));
    }
    drive.frames.push_back(std::move(frame));
    drive.true_T_first_frame.push_back(T_first_frame);
    drive.edge_T_first_frame.push_back(T_first_frame);
    drive.times_s.push_back(s);
    drive.travelled_m.push_back(s);
  }
  return drive;
}

Scenario small_study(const std::string& study) {
  Scenario scenario;
  scenario.slam_study.study = study;
  scenario.slam.loop.corrections = 10;
  return scenario;
}

std::string digest_of(const SlamTrial& trial) {
  Table runs = slam_run_table(), frames = slam_frame_table();
  append_slam_trial(trial, runs, frames);
  return results_digest({&runs, &frames});
}

}  // namespace

TEST_CASE("the floor of noise-free stems is zero, and a rigid move changes no figure of a path") {
  const SlamDrive drive = drive_by_hand(40, 0.0);
  const SlamQuality floor = judge_slam(drive, drive.true_T_first_frame, {});
  CHECK(floor.cluster_rmse_05_m < 1e-9);
  CHECK(floor.ate_m < 1e-9);
  FramePoses moved_poses = drive.true_T_first_frame;
  const Pose3 T_new_first = pose_from_rpy({10.0, -3.0, 2.0}, 0.1, -0.2, 1.0);
  for (Pose3& pose : moved_poses) pose = T_new_first * pose;
  CHECK(judge_slam(drive, moved_poses, {}).ate_m < 1e-9);
  // A path stretched about its middle by a tenth: its error is a tenth of its spread.
  FramePoses stretched = drive.true_T_first_frame;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Pose3& pose : stretched) middle += pose.translation() / 40.0;
  double spread_m2 = 0.0;
  for (Pose3& pose : stretched) {
    const Eigen::Vector3d out = pose.translation() - middle;
    spread_m2 += out.squaredNorm() / 40.0;
    pose.translation() = middle + 1.1 * out;
  }
  CHECK(judge_slam(drive, stretched, {}).ate_m == Approx(0.1 * std::sqrt(spread_m2)).epsilon(1e-6));
}

TEST_CASE("noise in the stems is the floor's noise of clusters") {
  const SlamDrive drive = drive_by_hand(40, 0.03);
  const SlamQuality floor = judge_slam(drive, drive.true_T_first_frame, {});
  // Two components of 0.03 m each.
  CHECK(floor.pooled_rmse_05_m == Approx(0.03 * std::sqrt(2.0)).epsilon(0.05));
  CHECK(floor.cluster_rmse_m == Approx(0.03 * std::sqrt(2.0)).epsilon(0.08));
}

TEST_CASE("every start and order is run, the same on one thread and on two") {
  const Scenario scenario = small_study("table1");
  const SlamTrial trial = run_slam_trial(drive_by_hand(60, 0.03), scenario, 0, 1);
  const auto cases = slam_cases(scenario);
  REQUIRE(cases.size() == 12);
  REQUIRE(trial.runs.size() == cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    CAPTURE(cases[i].start, cases[i].treatment);
    CHECK(trial.runs[i].start == cases[i].start);
    CHECK(trial.runs[i].T_first_frame.size() == 60);
    CHECK(std::isfinite(trial.runs[i].quality.blur));
    CHECK(trial.runs[i].quality.ate_m < 1.0);
  }
  CHECK(digest_of(run_slam_trial(drive_by_hand(60, 0.03), scenario, 0, 2)) == digest_of(trial));
}

TEST_CASE("methods stand beside the paper's loop, and true poses beside all") {
  const Scenario scenario = small_study("methods");
  const SlamTrial trial = run_slam_trial(drive_by_hand(60, 0.03), scenario, 0, 2);
  const auto rows = summarize_slam({trial}, slam_cases(scenario));
  REQUIRE(rows.size() == trial.runs.size());
  CHECK(rows.front().start == "edge");
  CHECK(rows.back().start == "true_poses");
  CHECK(rows.back().treatment == "landmark_ba");
  const Json json = slam_methods_json(rows, scenario).rows.back();
  CHECK(json["ate_m"].get<double>() < 0.03);
  CHECK(json["ate_m_interval"].is_null());  // one seed has no interval
  CHECK(json["seeds"] == 1);
}

TEST_CASE("a drive without key frames stays in the results") {
  const Scenario scenario = small_study("table1");
  const SlamTrial lost = run_slam_trial(SlamDrive{}, scenario, 0, 1);
  CHECK(lost.runs.empty());
  const SlamTrial good = run_slam_trial(drive_by_hand(30, 0.03), scenario, 1, 1);
  const auto rows = summarize_slam({lost, good}, slam_cases(scenario));
  CHECK(rows.front().done == 1);
  CHECK(rows.front().trials == 2);
  CHECK(slam_drives_table({lost, good}).rows.size() == 2);
  Table runs = slam_run_table(), frames = slam_frame_table();
  append_slam_trial(lost, runs, frames);
  CHECK(runs.rows() == 1);
  CHECK(runs.strings("status").front() == "no_key_frames");
  CHECK(frames.rows() == 0);
}

TEST_CASE("the paper's figures stand beside the start that is like its own") {
  const Scenario scenario = small_study("table1");
  const SlamTrial trial = run_slam_trial(drive_by_hand(30, 0.03), scenario, 0, 2);
  const SummaryTable table =
      slam_table1_json(summarize_slam({trial, trial}, slam_cases(scenario)), scenario);
  REQUIRE(table.rows.size() == 12);
  for (const std::string key : {"start", "order", "blur", "blur_floor", "cluster_rmse_m",
                                "cluster_rmse_floor_m", "ate_m", "corrections", "go_icp_calls"}) {
    CAPTURE(key);
    CHECK(table.rows[1].contains(key));
  }
  CHECK(table.rows[1]["paper"]["blur"] == 0.035);
  CHECK(table.rows[2]["paper"]["corrections"] == 71.0);
  CHECK_FALSE(table.rows[5].contains("paper"));
  CHECK(table.rows[1]["blur_interval"].size() == 2);
}
