#include "algo/odometry/loam/loam.h"

#include <algorithm>
#include <array>
#include <utility>

#include "algo/odometry/aggregate.h"
#include "algo/odometry/loam/recovery.h"
#include "algo/odometry/loam/rings.h"
#include "algo/odometry/stems/vertical.h"

namespace honka {
namespace {

/// Six unknowns, and a share of wrong pairs.
constexpr std::size_t kLeastMatches = 20;

KeyFrameSettings loam_key_frames(const LoamSettings& s) {
  KeyFrameSettings key;
  key.distance_m = s.key_distance_m;
  key.angle_deg = s.key_angle_deg;
  return key;
}

/// Pose of the lidar in a frame with z up. What stands is told from what leans by where z is
/// thought to be: on a steep slope the second look sees stems that the first took for leaning.
Pose3 level_pose(const Sweep& sweep, const LidarModel& model) {
  constexpr int kLooks = 3;
  Pose3 T_level_lidar = Pose3::Identity();
  for (int look = 0; look < kLooks; ++look) {
    const std::array posed = {PosedSweep{&sweep, T_level_lidar, T_level_lidar}};
    const Eigen::Vector3d up_in_level = estimate_vertical(posed, model).up;
    T_level_lidar = levelled_start(T_level_lidar.linear().transpose() * up_in_level);
  }
  return T_level_lidar;
}

}  // namespace

LoamOdometry::LoamOdometry(const LidarModel& model, const LoamSettings& settings)
    : model_(model),
      settings_(settings),
      step_rad_(azimuth_step_rad(model)),
      order_(model),
      key_frames_(loam_key_frames(settings)),
      map_(settings.map) {}

OdometryEstimate LoamOdometry::process(const Sweep& sweep) {
  // 1. The sweep's place in time.
  const SweepOrder::Verdict order = order_.judge(sweep);
  if (!order.placed) {
    last_.sweep = sweep.index;
    last_.status = OdometryStatus::kRefused;
    last_.cause = order.cause;
    return last_;
  }
  // 2. Edges and planes (Zhang2014, section V.A).
  const LoamFeatures features = extract_loam_features(sweep, model_, settings_.features);
  if (!started_) return start(sweep, features, order.cause);
  // 3. Every sweep: from constant velocity to the map, with part of the features.
  motion_.periods = order.elapsed_s / model_.sweep_period_s();
  LoamRegistration found = register_sweep(features);
  // 4. What it is worth; a sweep that fits nowhere near is looked for around.
  Judgement judgement = judge(features, found);
  // 5. Key frames: all features to the map, and into it.
  const bool registered = judgement.status != OdometryStatus::kPredicted;
  if (registered && key_frames_.is_key_frame(found.T_odom_lidar)) map_key_frame(features, found);
  carry_on(features, found, judgement);
  // 6. The motion within the sweep and the answer.
  if (order.cause != OdometryCause::kNone && judgement.cause != OdometryCause::kJump) {
    judgement.cause = order.cause;
  }
  return answer(sweep, found.covariance, judgement);
}

OdometryEstimate LoamOdometry::start(const Sweep& sweep, const LoamFeatures& features,
                                     OdometryCause cause) {
  if (cause == OdometryCause::kEmptyScan) {
    return answer(sweep, kUnobservedVariance * Covariance6::Identity(),
                  {OdometryStatus::kPredicted, cause});
  }
  motion_.T_odom_last = level_pose(sweep, model_);
  static_cast<void>(key_frames_.is_key_frame(motion_.T_odom_last));
  map_.add(features, DeskewedFeatures(features, Twist::Zero()), motion_.T_odom_last,
           settings_.registration.edge_noise_m, step_rad_);
  started_ = true;
  first_ = features;
  return answer(sweep, Covariance6::Zero(), {OdometryStatus::kRegistered, cause});
}

LoamRegistration LoamOdometry::register_sweep(const LoamFeatures& features) {
  const auto most = static_cast<std::size_t>(settings_.registration.sweep_features);
  const LoamFeatures few{thinned(features.edges, most), thinned(features.planes, most)};
  LoamRegistration found =
      register_features(few, map_, motion_, motion_.predicted(),
                        settings_.registration.sweep_rounds, settings_, model_);
  if (first_) found = restart_in_motion(few, found);
  return found;
}

/// The first sweep was taken as one at rest. Now that its motion shows, its features go to their
/// places: the origin stays where the lidar was at its start.
LoamRegistration LoamOdometry::restart_in_motion(const LoamFeatures& features,
                                                 const LoamRegistration& found) {
  const LoamFeatures first = *std::exchange(first_, std::nullopt);
  if (!motion_.allows(found.T_odom_lidar, settings_.motion, model_.sweep_period_s())) return found;
  motion_.last_twist = motion_.twist_to(found.T_odom_lidar);
  motion_.T_odom_last = motion_.T_odom_last * se3_exp(0.5 * motion_.last_twist);
  map_.clear();
  map_.add(first, DeskewedFeatures(first, motion_.last_twist), motion_.T_odom_last,
           settings_.registration.edge_noise_m, step_rad_);
  return register_features(features, map_, motion_, motion_.predicted(),
                           settings_.registration.sweep_rounds, settings_, model_);
}

LoamOdometry::Judgement LoamOdometry::judge(const LoamFeatures& features, LoamRegistration& found) {
  constexpr std::size_t kLeastEdges = 20;  // fewer have no usual share
  if (features.edges.size() >= kLeastEdges) {
    const double lost = settings_.motion.lost_share * usual_share_;
    if (found.close_share() < lost) {
      const LoamRegistration wide =
          recover(features, map_, motion_, motion_.predicted(), settings_, model_);
      if (wide.close_share() > std::max(lost, found.close_share())) found = wide;
    }
    // Neither here nor around.
    if (found.close_share() < 0.5 * lost) {
      return {OdometryStatus::kPredicted, OdometryCause::kNotConverged};
    }
  }
  if (found.edges_matched + found.planes_matched < kLeastMatches) {
    return {OdometryStatus::kPredicted, OdometryCause::kFewFeatures};
  }
  if (!motion_.allows(found.T_odom_lidar, settings_.motion, model_.sweep_period_s())) {
    return {OdometryStatus::kRegistered, OdometryCause::kJump};
  }
  if (found.weak_directions > 0) return {OdometryStatus::kDegenerate, OdometryCause::kUnobserved};
  return {};
}

void LoamOdometry::map_key_frame(const LoamFeatures& features, LoamRegistration& found) {
  const LoamRegistration refined =
      register_features(features, map_, motion_, found.T_odom_lidar,
                        settings_.registration.map_rounds, settings_, model_);
  if (motion_.allows(refined.T_odom_lidar, settings_.motion, model_.sweep_period_s())) {
    found = refined;
  }
  const Twist twist = sweep_twist(motion_, found.T_odom_lidar, settings_, model_);
  map_.add(features, DeskewedFeatures(features, twist), found.T_odom_lidar,
           settings_.registration.edge_noise_m, step_rad_);
}

/// The state for the next sweep.
void LoamOdometry::carry_on(const LoamFeatures& features, const LoamRegistration& found,
                            Judgement judgement) {
  constexpr std::int64_t kMostLost = 5;  // then what is seen is the map to go on with
  constexpr double kMemory = 0.05;       // of the usual share: twenty sweeps
  if (judgement.status == OdometryStatus::kPredicted) {
    motion_.T_odom_last = motion_.predicted();
    ++lost_sweeps_;
    coasted_periods_ += motion_.periods;
    if (coasted_periods_ >= kMostCoastedPeriods) motion_.last_twist.setZero();
    const bool seen = features.edges.size() + features.planes.size() >= kLeastMatches;
    if (seen && lost_sweeps_ >= kMostLost) {
      map_.add(features, DeskewedFeatures(features, motion_.last_twist), motion_.T_odom_last,
               settings_.registration.edge_noise_m, step_rad_);
      usual_share_ = 0.0;
    }
    return;
  }
  lost_sweeps_ = 0;
  coasted_periods_ = 0.0;
  last_registration_ = found;
  motion_.last_twist = sweep_twist(motion_, found.T_odom_lidar, settings_, model_);
  motion_.T_odom_last = found.T_odom_lidar;
  usual_share_ += (usual_share_ == 0.0 ? 1.0 : kMemory) * (found.close_share() - usual_share_);
}

OdometryEstimate LoamOdometry::answer(const Sweep& sweep, const Covariance6& covariance,
                                      Judgement judgement) {
  last_.sweep = sweep.index;
  last_.start_time_s = sweep.start_time_s;
  last_.end_time_s = sweep.start_time_s + model_.sweep_period_s();
  last_.T_odom_start = motion_.T_odom_last * se3_exp(-0.5 * motion_.last_twist);
  last_.T_odom_end = motion_.T_odom_last * se3_exp(0.5 * motion_.last_twist);
  last_.covariance = judgement.status == OdometryStatus::kPredicted
                         ? Covariance6(kUnobservedVariance * Covariance6::Identity())
                         : covariance;
  last_.status = judgement.status;
  last_.cause = judgement.cause;
  return last_;
}

}  // namespace honka
