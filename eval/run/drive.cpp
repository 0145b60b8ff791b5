#include "eval/run/drive.h"

#include <deque>
#include <set>

#include "algo/odometry/key_frames.h"
#include "eval/metrics/trajectory_alignment.h"
#include "eval/run/make_odometry.h"
#include "eval/run/odometry_drive.h"

namespace honka::eval {
namespace {

/// Gathers the sweeps of key frames from the estimates of a drive, in the order of time.
class KeyFrameBuilder {
 public:
  KeyFrameBuilder(const KeyFrameSettings& settings, const KeyFrameChoice& choice,
                  const sim::Vehicle& vehicle, TakeKeyFrame take)
      : sweeps_(static_cast<std::size_t>(settings.sweeps)),
        choice_(choice),
        vehicle_(vehicle),
        selector_(settings),
        take_(std::move(take)) {}

  /// `sweep` may be null where scans are not at hand.
  void add(const OdometryEstimate& estimate, const sim::TruthfulSweep* sweep) {
    const bool registered = estimate.status == OdometryStatus::kRegistered ||
                            estimate.status == OdometryStatus::kDegenerate;
    if (!registered) return;
    if (selector_.is_key_frame(estimate.T_odom_start) && choice_.holds(found_++)) {
      open_.push_back(begin(estimate));
    }
    for (Open& open : open_) {
      open.key_frame.sweeps.push_back({estimate.sweep, estimate.T_odom_start, estimate.T_odom_end});
      if (sweep != nullptr) open.scans.push_back(*sweep);
    }
    while (!open_.empty() && open_.front().key_frame.sweeps.size() == sweeps_) {
      take_(open_.front().key_frame, std::move(open_.front().scans));
      open_.pop_front();
    }
  }

 private:
  struct Open {
    KeyFrame key_frame;
    std::vector<sim::TruthfulSweep> scans;
  };

  [[nodiscard]] Open begin(const OdometryEstimate& estimate) const {
    KeyFrame key_frame;
    key_frame.time_s = estimate.start_time_s;
    key_frame.travelled_m = vehicle_.travelled_m(estimate.start_time_s);
    key_frame.T_odom_lidar = estimate.T_odom_start;
    key_frame.T_world_lidar = vehicle_.trajectory().T_world_lidar(estimate.start_time_s);
    return {key_frame, {}};
  }

  std::size_t sweeps_;
  KeyFrameChoice choice_;
  std::size_t found_ = 0;
  const sim::Vehicle& vehicle_;
  KeyFrameSelector selector_;
  TakeKeyFrame take_;
  std::deque<Open> open_;
};

/// Drives with an odometry that needs no returns, until the last chosen key frame is complete.
/// Returns the sweeps that the key frames are made of.
std::vector<std::int64_t> drive_without_scans(Drive& drive, const LidarModel& model,
                                              Odometry& odometry, const KeyFrameSettings& settings,
                                              const KeyFrameChoice& choice,
                                              const std::string& what) {
  std::set<std::int64_t> wanted;
  std::size_t complete = 0;
  KeyFrameBuilder builder(settings, choice, *drive.vehicle, [&](const KeyFrame& key_frame, auto&&) {
    ++complete;
    for (const FrameSweep& s : key_frame.sweeps) wanted.insert(s.index);
  });
  const std::int64_t sweeps = sweeps_of(*drive.vehicle, model);
  Progress progress(what.empty() ? what : what + ", poses alone", "sweeps", sweeps);
  for (std::int64_t k = 0; k < sweeps && complete < choice.count; ++k) {
    const OdometryEstimate estimate = odometry.process(empty_sweep(model, k));
    drive.track.add(estimate);
    builder.add(estimate, nullptr);
    progress.advance();
  }
  return {wanted.begin(), wanted.end()};
}

/// Casts what key frames need, once their poses are known.
void scan_key_frames(const Drive& drive, const sim::LidarSimulator& lidar,
                     const std::vector<std::int64_t>& wanted, const std::string& what, int threads,
                     KeyFrameBuilder& builder) {
  Progress progress(what, "sweeps", static_cast<std::int64_t>(wanted.size()));
  auto next = drive.track.estimates().begin();
  stream_sweeps(*drive.vehicle, lidar, wanted, threads, progress, [&](sim::TruthfulSweep&& sweep) {
    while (next->sweep < sweep.sweep.index) builder.add(*next++, nullptr);
    builder.add(*next++, &sweep);
  });
}

Pose3 laid_onto_world(const std::vector<KeyFrame>& key_frames) {
  PosePairs pairs;
  for (const KeyFrame& key_frame : key_frames) {
    pairs.poses.push_back({key_frame.time_s, key_frame.T_world_lidar, key_frame.T_odom_lidar});
  }
  const AlignmentResult fitted = align(pairs, Alignment::kYaw);
  if (fitted.status == AlignmentStatus::kAligned) return fitted.T_truth_estimate.rigid;
  return align(pairs, Alignment::kOrigin).T_truth_estimate.rigid;  // a machine that never moved
}

}  // namespace

DriveOrder prior_drive(const Scenario& scenario, const TrialWorld& world) {
  return {"prior", &world.prior_path, &scenario.map.prior_run, &world.when_mapped()};
}

DriveOrder work_drive(const Scenario& scenario, const TrialWorld& world) {
  return {"work", &world.work_path, &scenario.harvester, &world};
}

std::unique_ptr<sim::Vehicle> make_vehicle(const DriveOrder& order, std::uint64_t seed) {
  return std::make_unique<sim::Vehicle>(*order.path, order.stand->stand.terrain, *order.vehicle,
                                        derive_seed(seed, order.name));
}

Drive drive_and_scan(const DriveOrder& order, const Scenario& scenario, std::uint64_t seed,
                     const std::string& what, int threads, const TakeKeyFrame& take,
                     const KeyFrameChoice& choice) {
  Drive drive;
  drive.vehicle = make_vehicle(order, seed);
  const sim::LidarSimulator& lidar = *order.stand->lidar;
  const std::int64_t sweeps = sweeps_of(*drive.vehicle, lidar.model());
  const auto odometry = make_odometry(scenario.odometry, drive.vehicle->trajectory(), lidar.model(),
                                      sweeps, derive_seed(seed, order.name));
  KeyFrameBuilder builder(scenario.frame, choice, *drive.vehicle,
                          [&](const KeyFrame& key_frame, auto&& scans) {
                            drive.key_frames.push_back(key_frame);
                            take(key_frame, std::move(scans));
                          });
  if (odometry->needs_returns()) {
    Progress progress(what, "sweeps", sweeps);
    drive.track = drive_with_odometry(*drive.vehicle, lidar, *odometry, threads, progress,
                                      [&](DriveSweep&& s) { builder.add(s.estimate, &s.sweep); });
    drive.T_world_odom = laid_onto_world(drive.key_frames);
  } else {
    const auto wanted =
        drive_without_scans(drive, lidar.model(), *odometry, scenario.frame, choice, what);
    scan_key_frames(drive, lidar, wanted, what, threads, builder);
  }
  return drive;
}

std::vector<PosedSweep> posed(const KeyFrame& key_frame, const std::vector<Sweep>& sweeps) {
  std::vector<PosedSweep> result;
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const FrameSweep& poses = key_frame.sweeps[i];
    result.push_back({&sweeps[i], poses.T_odom_start, poses.T_odom_end});
  }
  return result;
}

std::vector<Sweep> scans_of(std::vector<sim::TruthfulSweep> sweeps) {
  std::vector<Sweep> scans;
  for (sim::TruthfulSweep& sweep : sweeps) scans.push_back(std::move(sweep.sweep));
  return scans;
}

}  // namespace honka::eval
