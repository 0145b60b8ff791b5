#include "algo/odometry/stems/stem_odometry.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "algo/odometry/stems/search.h"
#include "algo/odometry/stems/vertical.h"
#include "algo/types/angles.h"

namespace honka {
namespace {

constexpr double kKnown = 1e-3;  // m and rad: a pose by definition
constexpr double kCoast_s =
    1.0;  // constant velocity is believed this long; then the machine stands
constexpr double kMostGap_s = 10.0;  // the uncertainty of the prediction grows no further

Covariance6 inverse_of(const Covariance6& m) { return m.ldlt().solve(Covariance6::Identity()); }

/// Of a registration alone; directions without information get a bounded variance.
Covariance6 covariance_from(const Covariance6& information) {
  return inverse_of(information + Covariance6::Identity() / kUnobservedVariance);
}

KeyFrameSettings key_frames_of(const StemLandmarkSettings& settings) {
  KeyFrameSettings key_frames;
  key_frames.distance_m = settings.key_distance_m;
  key_frames.angle_deg = settings.key_angle_deg;
  return key_frames;
}

double largest_sigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()(2), 0.0));
}

}  // namespace

StemOdometry::StemOdometry(const LidarModel& model, const StemOdometrySettings& settings)
    : model_(model),
      settings_(settings),
      order_(model),
      finder_(model, settings.points),
      picker_(model, settings.ground, settings.points.min_range_m),
      stems_(settings.landmarks),
      ground_(settings.ground),
      registration_(settings.registration, settings.landmarks, settings.ground),
      motion_(settings.registration.acceleration_m_s2,
              deg_to_rad(settings.registration.turn_acceleration_deg_s2)),
      key_frames_(key_frames_of(settings.landmarks)),
      lost_stems_(settings.landmarks) {}

OdometryEstimate StemOdometry::process(const Sweep& sweep) {
  // Time: can the sweep follow the last one?
  const SweepOrder::Verdict verdict = order_.judge(sweep);
  if (!verdict.placed) return refused(sweep, verdict.cause);
  // Prediction: constant velocity.
  predict(verdict.elapsed_s);
  if (!started_ && verdict.cause != OdometryCause::kEmptyScan) start(sweep);
  // Stems and ground of this sweep.
  find_features(sweep);
  // Registration to the maps; a lost place is searched around.
  Outcome outcome = judge(register_features(), verdict.cause);
  if (outcome.status == OdometryStatus::kPredicted) outcome = search(outcome, verdict.cause);
  accept(outcome);
  // The second sweep tells how the lidar moved during the first.
  if (first_) outcome = start_again_in_motion(outcome, verdict.elapsed_s);
  // The maps learn from key frames.
  learn(outcome);
  return estimate(sweep, outcome);
}

void StemOdometry::start(const Sweep& sweep) {
  const PosedSweep still{&sweep, Pose3::Identity(), Pose3::Identity()};
  VerticalSettings vertical;
  vertical.points = settings_.points;
  motion_.start(levelled_start(estimate_vertical({&still, 1}, model_, vertical).up));
  started_ = true;
}

void StemOdometry::predict(double elapsed_s) {
  const double coast_s = std::clamp(kCoast_s - coasted_s_, 0.0, elapsed_s);
  motion_.predict(coast_s);
  coasted_s_ += elapsed_s;
  if (coast_s >= elapsed_s) return;
  motion_.halt();
  motion_.predict(std::min(elapsed_s - coast_s, kMostGap_s));
}

void StemOdometry::find_features(const Sweep& sweep) {
  const Eigen::Vector3d up = motion_.T_odom_lidar().linear().row(2);
  features_.points = finder_.find(sweep, up);
  features_.ground = picker_.pick(sweep, up);
}

StemFit StemOdometry::register_features() {
  stems_.look_around(motion_.T_odom_lidar().translation().head<2>());
  const Covariance6 prior = inverse_of(motion_.pose_covariance());
  StemFit fit;
  // The second pass takes the motion within the sweep from the first.
  for (int pass = 0; pass < 2; ++pass) {
    place(features_.points, features_.ground, motion_.body_velocity(fit.delta),
          model_.sweep_period_s(), placed_);
    fit = registration_.fit(placed_, stems_, ground_, motion_.T_odom_lidar(), prior, fit.delta);
  }
  return fit;
}

StemOdometry::Outcome StemOdometry::judge(const StemFit& fit, OdometryCause cause_before) const {
  Outcome outcome{fit, OdometryStatus::kRegistered, cause_before};
  const auto predicted = [&](OdometryCause cause) {
    outcome.status = OdometryStatus::kPredicted;
    if (cause_before != OdometryCause::kEmptyScan) outcome.cause = cause;
    return outcome;
  };
  const auto& s = settings_.registration;
  const auto least = static_cast<std::size_t>(s.min_stems);
  if (placed_.sightings.size() < least) return predicted(OdometryCause::kFewFeatures);
  if (stems_.size() == 0) {  // the first sweep of a map says where the map is
    outcome.fit.information = Covariance6::Identity() / (kKnown * kKnown);
    return outcome;
  }
  if (fit.stems < least || fit.share < s.min_share) return predicted(OdometryCause::kJump);
  if (!fit.at_rest) return predicted(OdometryCause::kNotConverged);
  const Covariance6 covariance = covariance_from(fit.information);
  if (largest_sigma(covariance.topLeftCorner<3, 3>()) > s.degenerate_m ||
      largest_sigma(covariance.bottomRightCorner<3, 3>()) > deg_to_rad(s.degenerate_deg)) {
    outcome.status = OdometryStatus::kDegenerate;
    if (cause_before == OdometryCause::kNone) outcome.cause = OdometryCause::kUnobserved;
  }
  return outcome;
}

StemOdometry::Outcome StemOdometry::search(const Outcome& lost, OdometryCause cause_before) {
  if (lost.cause != OdometryCause::kJump && lost.cause != OdometryCause::kNotConverged) return lost;
  const auto T_odom_found =
      search_place(placed_.sightings, stems_, motion_.T_odom_lidar(), settings_.registration);
  if (!T_odom_found) return lost;
  const MotionFilter before = motion_;
  motion_.jump_to(*T_odom_found);
  const bool gap = cause_before == OdometryCause::kGap;
  const Outcome found = judge(register_features(), gap ? cause_before : OdometryCause::kJump);
  if (found.status != OdometryStatus::kPredicted) return found;
  motion_ = before;
  return lost;
}

void StemOdometry::accept(const Outcome& outcome) {
  if (outcome.status == OdometryStatus::kPredicted) {
    count_lost();
    return;
  }
  lost_sweeps_ = 0;
  coasted_s_ = 0.0;
  if (stems_.size() == 0) return;
  const Covariance6 prior = inverse_of(motion_.pose_covariance());
  motion_.correct(outcome.fit.delta, inverse_of(prior + outcome.fit.information));
}

void StemOdometry::count_lost() {
  const auto& s = settings_.registration;
  if (placed_.sightings.size() < static_cast<std::size_t>(s.min_stems)) return;
  // Only what stays from sweep to sweep can be a place; noise cannot.
  const Pose3& T_odom_mid = motion_.T_odom_lidar();
  std::vector<StemPair> pairs;
  lost_stems_.associate(placed_.sightings, T_odom_mid, s.gate_m, pairs);
  const auto seen = static_cast<double>(placed_.sightings.size());
  lost_sweeps_ = static_cast<double>(pairs.size()) < s.min_share * seen ? 1 : lost_sweeps_ + 1;
  lost_stems_.clear();
  lost_stems_.learn(placed_.sightings, T_odom_mid, {});
}

StemOdometry::Outcome StemOdometry::start_again_in_motion(const Outcome& second, double elapsed_s) {
  const Features first = *std::exchange(first_, std::nullopt);
  if (second.status == OdometryStatus::kPredicted || second.cause != OdometryCause::kNone) {
    return second;
  }
  const double period_s = model_.sweep_period_s();
  Outcome again = second;
  // A first answer compares a bent sweep with a straightened one: three rounds take 6 cm to 1 cm.
  for (int round = 0; round < 3 && again.status != OdometryStatus::kPredicted; ++round) {
    const Twist velocity = motion_.body_velocity();
    // The origin is where the lidar is at the start of the first sweep, not amid it.
    motion_.start(last_.T_odom_start * se3_exp(velocity * (0.5 * period_s)), velocity);
    clear_maps();
    place(first.points, first.ground, velocity, period_s, placed_);
    add_to_maps({});
    motion_.predict(elapsed_s);
    again = judge(register_features(), OdometryCause::kNone);
    accept(again);
  }
  return again;
}

void StemOdometry::learn(const Outcome& outcome) {
  const bool fresh = stems_.size() == 0;
  if (lost_sweeps_ >= settings_.registration.restart_sweeps) {
    clear_maps();
    add_to_maps({});
    lost_sweeps_ = 0;
  } else if (outcome.status != OdometryStatus::kPredicted &&
             key_frames_.is_key_frame(motion_.T_odom_lidar())) {
    if (fresh) first_ = features_;
    add_to_maps(registration_.pairs());
  }
}

void StemOdometry::add_to_maps(std::span<const StemPair> pairs) {
  const Pose3& T_odom_mid = motion_.T_odom_lidar();
  stems_.look_around(T_odom_mid.translation().head<2>());
  stems_.learn(placed_.sightings, T_odom_mid, pairs);
  for (const Eigen::Vector3d& p : placed_.ground_m) ground_.add(T_odom_mid * p);
}

void StemOdometry::clear_maps() {
  stems_.clear();
  ground_.clear();
  key_frames_ = KeyFrameSelector(key_frames_of(settings_.landmarks));
}

OdometryEstimate StemOdometry::estimate(const Sweep& sweep, const Outcome& outcome) {
  const double period_s = model_.sweep_period_s();
  OdometryEstimate e;
  e.sweep = sweep.index;
  e.start_time_s = sweep.start_time_s;
  e.end_time_s = sweep.start_time_s + period_s;
  const Pose3 T_mid_end = se3_exp(motion_.body_velocity() * (0.5 * period_s));
  e.T_odom_start = motion_.T_odom_lidar() * T_mid_end.inverse();
  e.T_odom_end = motion_.T_odom_lidar() * T_mid_end;
  e.status = outcome.status;
  e.cause = outcome.cause;
  e.covariance = Covariance6::Identity() * kUnobservedVariance;
  if (outcome.status != OdometryStatus::kPredicted) {
    Covariance6 R = Covariance6::Zero();  // axes of odom → axes of the lidar at the end
    R.topLeftCorner<3, 3>() = R.bottomRightCorner<3, 3>() = e.T_odom_end.linear().transpose();
    e.covariance = R * covariance_from(outcome.fit.information) * R.transpose();
  }
  last_ = e;
  return e;
}

OdometryEstimate StemOdometry::refused(const Sweep& sweep, OdometryCause cause) const {
  OdometryEstimate e = last_;
  e.sweep = sweep.index;
  e.T_odom_start = e.T_odom_end = last_.T_odom_end;
  e.covariance = Covariance6::Identity() * kUnobservedVariance;
  e.status = OdometryStatus::kRefused;
  e.cause = cause;
  return e;
}

}  // namespace honka
