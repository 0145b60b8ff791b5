// Tracks of drives that are made by hand, judged by known answers.
#include <catch2/catch.hpp>

#include "algo/types/user_error.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/localize/tracking_rows.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// 0.1 m a scan along x, the odometry exact; at scan 100 the machine is put 300 m to the north.
TrackingDrive hand_made_drive() {
  TrackingDrive drive;
  drive.kidnapped_s = 10.0;
  for (int k = 0; k < 200; ++k) {
    TrackedScan scan;
    scan.time_s = 0.1 * k;
    scan.T_odom_lidar = {{0.1 * k, 0.0}, 0.0};
    scan.T_world_lidar = {{0.1 * k, k < 100 ? 0.0 : 300.0}, 0.0};
    drive.scans.push_back(scan);
  }
  return drive;
}

/// A track that is 0.3 m off, and stays on the first road until 2 s after the kidnapping.
TrackedRun hand_made_run(const TrackingDrive& drive) {
  TrackedRun run;
  run.what = {"li2020", 0, false};
  for (const TrackedScan& scan : drive.scans) {
    TrackedPose pose;
    pose.time_s = scan.time_s;
    pose.state = TrackState::kTracking;
    const bool unaware = scan.time_s < 12.0;
    pose.belief.T_map_lidar = {{scan.T_world_lidar.translation_m.x(), unaware ? 0.3 : 300.3}, 0.0};
    pose.belief.covariance = Eigen::Matrix3d::Identity() * 0.09;
    run.poses.push_back(pose);
  }
  run.events = {{1.0, TrackEvent::Kind::kInitialised, 0.0},
                {12.0, TrackEvent::Kind::kKidnapped, 300.0},
                {12.0, TrackEvent::Kind::kRecovered, 300.0}};
  return run;
}

}  // namespace

TEST_CASE("A track is judged apart from the time between kidnapping and report") {
  const TrackingDrive drive = hand_made_drive();
  const TrackingRow row = judge_track(drive, hand_made_run(drive), Scenario(), 0);
  CHECK(row.with_pose_share == Approx(1.0));
  CHECK(row.track_rmse_m.value() == Approx(0.3));
  CHECK(row.track_max_m.value() == Approx(0.3));
  CHECK(row.nees_mean.value() == Approx(1.0));
  CHECK(row.nees_inside.value() == Approx(1.0));
  CHECK(row.detect_s.value() == Approx(2.0));
  CHECK(row.recover_s.value() == Approx(2.0));
  CHECK(row.false_kidnappings == 0);
  CHECK(row.odometry_rmse_m.value() == Approx(0.0).margin(1e-12));
  CHECK_FALSE(row.fix_rmse_m);
  CHECK(row.nees_tracking.value() == Approx(1.0));
  CHECK_FALSE(row.nees_coasting);
  CHECK(row.stretches == 1);  // 17.9 m, 10 m share an error
}

TEST_CASE("A map of trees is asked of a source that lists them") {
  CHECK(lists_trees("inventory"));
  CHECK(lists_trees("airborne"));
  CHECK_FALSE(lists_trees("prior_run"));
  Scenario scenario;
  CHECK_THROWS_AS(source_map(sim::Stand{}, scenario, 1), UserError);
}

TEST_CASE("The longest coast is judged at its end, and its end is when the track says so") {
  const TrackingDrive drive = hand_made_drive();
  TrackedRun run = hand_made_run(drive);
  for (std::size_t k = 30; k < 80; ++k) {
    run.poses[k].state = TrackState::kCoasting;
    run.poses[k].since_fix_s = 0.1 * static_cast<double>(k - 30);
    run.poses[k].belief.covariance = Eigen::Matrix3d::Identity() * 0.01;
  }
  run.events.insert(run.events.begin() + 1, {8.0, TrackEvent::Kind::kRecovered, 0.1});
  const TrackingRow row = judge_track(drive, run, Scenario(), 0);
  CHECK(row.longest_coast_s.value() == Approx(4.9));
  CHECK(row.coast_error_m.value() == Approx(0.3));
  CHECK(row.coast_sigma_m.value() == Approx(0.1));
  CHECK(row.coast_end_s.value() == Approx(8.0));
  CHECK(row.nees_tracking.value() == Approx(1.0));
  CHECK(row.nees_coasting.value() == Approx(9.0));
  CHECK(row.nees_inside.value() == Approx(130.0 / 180.0));
}
