#include "eval/run/localize/tracking_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>

#include "algo/odometry/aggregate.h"
#include "algo/stems/extract.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "eval/run/drive.h"
#include "eval/run/localize/source_map.h"
#include "eval/run/trial_world.h"
#include "sim/forest/forest.h"
#include "sim/harvester/paths.h"

namespace honka::eval {
namespace {

/// A stand, and the ways of the two drives through it.
struct TrackingWorld : SeenStand {
  std::uint64_t seed = 0;
  sim::Polyline first, second;
};

TrackingWorld make_tracking_world(const Scenario& scenario, std::int64_t trial) {
  TrackingWorld world;
  world.seed = derive_seed(static_cast<std::uint64_t>(scenario.seed), "tracking_trial",
                           {static_cast<std::uint64_t>(trial)});
  const Eigen::AlignedBox2d extent(
      Eigen::Vector2d::Zero(), Eigen::Vector2d(scenario.forest.width_m, scenario.forest.length_m));
  world.first = sim::work_path(extent, scenario.protocol.path_length_m, world.seed);
  std::vector<sim::Polyline> roads = {world.first};
  if (scenario.tracking.second_length_m > 0.0) {
    world.second = sim::work_path(extent, scenario.tracking.second_length_m,
                                  derive_seed(world.seed, "second_drive"));
    // From its far end, so that the machine is carried a long way.
    const Eigen::Vector2d& end = world.first.back();
    if ((world.second.front() - end).norm() < (world.second.back() - end).norm()) {
      std::reverse(world.second.begin(), world.second.end());
    }
    roads.push_back(world.second);
  }
  world.stand = sim::make_stand(scenario.forest, roads, world.seed);
  world.surfaces =
      std::make_unique<sim::World>(sim::make_world(world.stand, scenario.forest, world.seed));
  world.lidar = std::make_unique<sim::LidarSimulator>(*world.surfaces, scenario.lidar, world.seed);
  return world;
}

Pose2 level_plane(const Pose3& T_a_lidar) { return planar(levelled(T_a_lidar)); }

/// Keeps the last frames of a drive, and finds the stems of every `localize_every_m`.
class ViewFinder {
 public:
  struct Seen {
    double time_s = 0.0;
    std::vector<std::vector<Eigen::Vector2d>> stems;
  };

  ViewFinder(const Scenario& scenario, const LidarModel& model)
      : scenario_(scenario), model_(model) {
    for (const std::int64_t n : scenario.tracking.frames) {
      most_frames_ = std::max(most_frames_, static_cast<std::size_t>(n));
    }
  }

  void take(const KeyFrame& frame, std::vector<sim::TruthfulSweep>&& sweeps) {
    frames_.push_back({frame, scans_of(std::move(sweeps))});
    if (frames_.size() > most_frames_) frames_.pop_front();
    const Pose2 T_odom_lidar = level_plane(frame.T_odom_lidar);
    const bool near =
        T_odom_before_ && (T_odom_lidar.translation_m - T_odom_before_->translation_m).norm() <
                              scenario_.tracking.localize_every_m;
    if (near) return;
    T_odom_before_ = T_odom_lidar;
    seen.push_back({frame.time_s, {}});
    for (const std::int64_t n : scenario_.tracking.frames) {
      seen.back().stems.push_back(stems_of_last(static_cast<std::size_t>(n)));
    }
  }

  std::vector<Seen> seen;

 private:
  struct Frame {
    KeyFrame key_frame;
    std::vector<Sweep> scans;
  };

  [[nodiscard]] std::vector<Eigen::Vector2d> stems_of_last(std::size_t n) const {
    std::vector<PosedSweep> sweeps;
    for (std::size_t k = frames_.size() - std::min(n, frames_.size()); k < frames_.size(); ++k) {
      for (const PosedSweep& sweep : posed(frames_[k].key_frame, frames_[k].scans)) {
        sweeps.push_back(sweep);
      }
    }
    const LocalCloud cloud =
        aggregate(sweeps, model_, scenario_.frame, frames_.back().key_frame.T_odom_lidar);
    std::vector<Eigen::Vector2d> stems;
    for (const ObservedStem& stem : extract_stems(cloud, scenario_.stems).stems) {
      stems.push_back(stem.position_m);
    }
    return stems;
  }

  const Scenario& scenario_;
  const LidarModel& model_;
  std::size_t most_frames_ = 1;
  std::deque<Frame> frames_;
  std::optional<Pose2> T_odom_before_;
};

/// One part of the drive: scans and views on its own clock and in its own odometry's frame.
TrackingDrive drive_part(const DriveOrder& order, const Scenario& scenario, std::uint64_t seed,
                         std::int64_t trial, int threads) {
  ViewFinder finder(scenario, order.stand->lidar->model());
  const Drive drive =
      drive_and_scan(order, scenario, seed, fmt::format("trial {}: {} drive", trial, order.name),
                     threads, [&](const KeyFrame& frame, std::vector<sim::TruthfulSweep>&& sweeps) {
                       finder.take(frame, std::move(sweeps));
                     });
  TrackingDrive part;
  auto next = finder.seen.begin();
  for (const OdometryEstimate& estimate : drive.track.estimates()) {
    const double time_s = estimate.start_time_s;
    if (next != finder.seen.end() && next->time_s <= time_s) {
      part.views.push_back({part.scans.size(), std::move(next->stems)});
      ++next;
    }
    part.scans.push_back({time_s, level_plane(estimate.T_odom_start), planar_covariance(estimate),
                          level_plane(drive.vehicle->trajectory().T_world_lidar(time_s))});
  }
  return part;
}

/// Appends a part as one odometry would know it: the next scan, at the same place.
void append_part(const TrackingDrive& part, double period_s, TrackingDrive& drive) {
  const std::size_t before = drive.scans.size();
  double start_s = 0.0;
  Pose2 T_odom_part;
  if (before > 0) {
    start_s = drive.scans.back().time_s + period_s - part.scans.front().time_s;
    T_odom_part = drive.scans.back().T_odom_lidar * part.scans.front().T_odom_lidar.inverse();
  }
  for (TrackedScan scan : part.scans) {
    scan.time_s += start_s;
    scan.T_odom_lidar = T_odom_part * scan.T_odom_lidar;
    drive.scans.push_back(scan);
  }
  for (TrackedView view : part.views) {
    view.scan += before;
    drive.views.push_back(std::move(view));
  }
}

sim::Polyline unmapped_way(const sim::Polyline& path, const TrackingStudySettings& settings) {
  sim::Polyline way;
  const double end_m = settings.unmapped_from_m + settings.unmapped_length_m;
  if (settings.unmapped_length_m <= 0.0) return way;
  for (double along_m = settings.unmapped_from_m; along_m < end_m; along_m += 1.0) {
    way.push_back(sim::point_at(path, along_m));
  }
  return way;
}

void add_map(const TrackingWorld& world, const Scenario& scenario, TrackingDrive& drive) {
  const sim::Polyline hole = unmapped_way(world.first, scenario.tracking);
  for (const Stem& stem : source_map(world.stand, scenario, world.seed)) {
    const bool hidden =
        sim::distance_m(hole, stem.position_m) < scenario.tracking.unmapped_margin_m;
    (hidden ? drive.hidden_m : drive.map_m).push_back(stem.position_m);
  }
}

}  // namespace

TrackingDrive make_tracking_drive(const Scenario& scenario, std::int64_t trial, int threads) {
  const TrackingWorld world = make_tracking_world(scenario, trial);
  const double period_s = world.lidar->model().sweep_period_s();
  TrackingDrive drive;
  add_map(world, scenario, drive);
  const DriveOrder first{"first", &world.first, &scenario.harvester, &world};
  append_part(drive_part(first, scenario, world.seed, trial, threads), period_s, drive);
  if (world.second.empty() || drive.scans.empty()) return drive;
  const DriveOrder second{"second", &world.second, &scenario.harvester, &world};
  const TrackingDrive part = drive_part(second, scenario, world.seed, trial, threads);
  if (part.scans.empty()) return drive;
  const Pose2& left = drive.scans.back().T_world_lidar;
  drive.carried_m = (part.scans.front().T_world_lidar.translation_m - left.translation_m).norm();
  const std::size_t before = drive.scans.size();
  append_part(part, period_s, drive);
  drive.kidnapped_s = drive.scans[before].time_s;
  return drive;
}

}  // namespace honka::eval
