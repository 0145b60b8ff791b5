// The drive that feeds SLAM: key frames of the edge's odometry, stems of scans, truth apart.
#include <catch2/catch.hpp>
#include <cmath>

#include "algo/geometry/se3.h"
#include "eval/run/slam/edge_frames.h"
#include "eval/run/slam/frame_scores.h"
#include "eval/run/slam/slam_drive.h"
#include "eval/run/slam/slam_world.h"

using namespace honka;
using namespace honka::eval;

namespace {

/// A short strip with bare stems: one hop, one stop with one swing.
Scenario short_strip() {
  Scenario scenario;
  scenario.forest.width_m = 40.0;
  scenario.forest.length_m = 30.0;
  scenario.forest.margin_m = 25.0;
  scenario.forest.density_per_ha = 940.0;
  scenario.forest.crown.branches = false;
  scenario.forest.crown.foliage = false;
  scenario.forest.undergrowth.bushes_per_ha = 0.0;
  scenario.forest.terrain.relief_m = 1.0;
  scenario.harvester.least_hop_m = scenario.harvester.most_hop_m = 2.0;
  scenario.harvester.stems_per_stop = 1;
  scenario.harvester.process_s = 0.0;
  scenario.harvester.least_swing_deg = scenario.harvester.most_swing_deg = 30.0;
  scenario.harvester.swing_rate_deg_s = 25.0;
  scenario.protocol.path_length_m = 2.0;
  scenario.odometry.source = "stems";
  scenario.stems.height_band = true;
  scenario.stems.centre = "bias_corrected";
  scenario.stems.max_range_m = 35.0;
  return scenario;
}

void check_same(const FramePoses& a, const FramePoses& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].matrix() == b[i].matrix());
}

OdometryEstimate estimate_at(std::int64_t sweep, double x_m, OdometryStatus status) {
  OdometryEstimate estimate;
  estimate.sweep = sweep;
  estimate.start_time_s = 0.1 * static_cast<double>(sweep);
  estimate.T_odom_start.translation().x() = x_m;
  estimate.T_odom_end = estimate.T_odom_start;
  estimate.status = status;
  return estimate;
}

}  // namespace

TEST_CASE("a drive for SLAM has the same digits on one thread and on two, and keeps truth apart") {
  const Scenario scenario = short_strip();
  const SlamDrive drive = drive_for_slam(scenario, 0, 1, "short");
  REQUIRE(drive.frames.size() > 10);
  CHECK(drive.sweeps > 60);
  CHECK(drive.times_s.size() == drive.frames.size());
  CHECK(drive.edge_T_first_frame.front().matrix().isIdentity(0.0));
  CHECK(drive.true_T_first_frame.front().matrix().isIdentity(0.0));

  const SlamDrive again = drive_for_slam(scenario, 0, 2, "short");
  check_same(drive.edge_T_first_frame, again.edge_T_first_frame);
  check_same(drive.true_T_first_frame, again.true_T_first_frame);
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    CHECK(drive.frames[i].number == static_cast<std::int64_t>(i));
    CHECK(drive.frames[i].points_m == again.frames[i].points_m);
  }

  // Key frames keep their distance by the odometry's own account, and that account errs.
  double greatest_error_m = 0.0;
  for (std::size_t i = 1; i < drive.frames.size(); ++i) {
    const Pose3 step = drive.edge_T_first_frame[i - 1].inverse() * drive.edge_T_first_frame[i];
    const bool far = step.translation().norm() >= scenario.slam.keyframe.distance_m - 1e-6;
    const bool turned =
        so3_log(step.linear()).norm() >= deg_to_rad(scenario.slam.keyframe.angle_deg) - 1e-6;
    CHECK((far || turned));
    CHECK(drive.times_s[i] > drive.times_s[i - 1]);
    const Eigen::Vector3d error =
        drive.edge_T_first_frame[i].translation() - drive.true_T_first_frame[i].translation();
    greatest_error_m = std::max(greatest_error_m, error.norm());
  }
  CHECK(greatest_error_m > 1e-5);
  CHECK(greatest_error_m < 0.3);

  // Stems lie where trees stand, within the noise of scans, never exactly.
  const FrameScores scores = score_frames(drive, ViewCone{}, 0.5);
  CHECK(scores.frames == static_cast<std::int64_t>(drive.frames.size()));
  CHECK(scores.found > 20 * scores.frames);
  CHECK(scores.found_matched > 0.9 * static_cast<double>(scores.found));
  CHECK(scores.truth_matched <= scores.truth);
  const auto matched = static_cast<double>(scores.found_matched);
  CHECK(std::sqrt(0.5 * scores.planar_m2 / matched) < 0.15);
  CHECK(std::sqrt(0.5 * scores.planar_m2 / matched) > 0.005);
  CHECK(std::sqrt(scores.height_m2 / matched) < 0.5);
}

TEST_CASE("the forest goes on beyond the strip and the road stays inside") {
  Scenario scenario = short_strip();
  scenario.protocol.path_length_m = 20.0;
  const SlamWorld world = make_slam_world(scenario, 1);
  CHECK(world.stand.trees.size() == 677);  // 940/ha on 90 × 80 m
  CHECK(trees_on_strip(world.stand) > 70);
  CHECK(trees_on_strip(world.stand) < 150);
  for (const Eigen::Vector2d& corner : world.road) {
    CHECK(world.stand.extent_m.contains(corner));
  }
  double nearest_m = 1e9;
  for (const sim::Tree& tree : world.stand.trees) {
    nearest_m = std::min(nearest_m, sim::distance_m(world.road, tree.base_m.head<2>()));
  }
  CHECK(nearest_m >= scenario.forest.corridor_half_width_m);
  CHECK(make_slam_world(scenario, 0).road.front() != world.road.front());
}

TEST_CASE("a key frame holds the next sweeps that were placed, and what the end cuts short goes") {
  KeyFrameSettings settings;
  settings.distance_m = 1.0;
  settings.sweeps = 3;
  EdgeFrameGatherer gatherer(settings);
  const auto registered = OdometryStatus::kRegistered, lost = OdometryStatus::kPredicted;
  // Key frames at sweeps 0, 2 and 6; sweep 3 is lost.
  const std::vector<std::pair<double, OdometryStatus>> sweeps = {
      {0.0, registered}, {0.5, registered}, {1.1, registered}, {1.2, lost},
      {1.3, registered}, {1.4, registered}, {2.5, registered}, {2.6, registered}};
  std::vector<EdgeFrame> frames;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    Sweep sweep;
    sweep.index = static_cast<std::int64_t>(i);
    gatherer.add(estimate_at(sweep.index, sweeps[i].first, sweeps[i].second), sweep);
    for (EdgeFrame& frame : gatherer.take_complete()) frames.push_back(std::move(frame));
  }
  REQUIRE(frames.size() == 2);
  const auto indices = [](const EdgeFrame& frame) {
    std::vector<std::int64_t> list;
    for (const auto& scan : frame.scans) list.push_back(scan.sweep->index);
    return list;
  };
  CHECK(indices(frames[0]) == std::vector<std::int64_t>{0, 1, 2});
  CHECK(indices(frames[1]) == std::vector<std::int64_t>{2, 4, 5});
  CHECK(frames[0].scans[2].sweep == frames[1].scans[0].sweep);
  CHECK(frames[1].time_s == Approx(0.2));
  CHECK(gatherer.unregistered() == 1);
}
