#include "algo/localize/tracking/tracker.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "algo/types/user_error.h"

namespace honka {
namespace {

/// Rivals remembered at once: wrong fixes between right ones found rivals of their own.
constexpr std::size_t kMostRivals = 8;

bool is_finite_pose(const Pose2& T) {
  return T.translation_m.allFinite() && std::isfinite(T.yaw_rad);
}

bool is_proper_covariance(const Eigen::Matrix3d& m) {
  return m.allFinite() && m.isApprox(m.transpose(), 1e-9) &&
         Eigen::LLT<Eigen::Matrix3d>(m).info() == Eigen::Success;
}

/// As above; directions without any error are allowed.
bool is_odometry_covariance(const Eigen::Matrix3d& m) {
  return m.allFinite() && (m - m.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * m.norm() &&
         Eigen::LDLT<Eigen::Matrix3d>(m).isPositive();
}

}  // namespace

std::string_view name_of(TrackState state) {
  constexpr std::array<std::string_view, 4> kNames = {"searching", "tracking", "coasting", "lost"};
  return kNames.at(static_cast<std::size_t>(state));
}

std::string_view name_of(TrackEvent::Kind kind) {
  constexpr std::array<std::string_view, 5> kNames = {"initialised", "coasting", "lost",
                                                      "kidnapped", "recovered"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string_view name_of(FixUse use) {
  constexpr std::array<std::string_view, 5> kNames = {"used", "rejected", "held", "restart",
                                                      "refused"};
  return kNames.at(static_cast<std::size_t>(use));
}

PoseTracker::PoseTracker(const TrackingSettings& settings) : settings_(settings) {
  const bool sane = settings.gate_probability > 0.0 && settings.gate_probability < 1.0 &&
                    settings.confirm_fixes >= 1 && settings.lost_after >= 1 &&
                    settings.fix_sigma_m > 0.0 && settings.fix_sigma_deg > 0.0 &&
                    settings.shared_length_m > 0.0 && settings.odometry.drift_length_m > 0.0;
  if (!sane) {
    throw UserError(
        "tracking: gate_probability lies between 0 and 1, confirm_fixes and lost_after are at "
        "least 1, fix_sigma_m, fix_sigma_deg, shared_length_m and odometry.drift_length_m above 0");
  }
  gate_ = chi_square_3_quantile(settings.gate_probability);
}

TrackedPose PoseTracker::add_odometry(double time_s, const Pose2& T_odom_lidar,
                                      const std::optional<Eigen::Matrix3d>& covariance) {
  if (!std::isfinite(time_s) || !is_finite_pose(T_odom_lidar)) {
    throw UserError(fmt::format("tracking: odometry at {} s is not finite", time_s));
  }
  if (covariance && !is_odometry_covariance(*covariance)) {
    throw UserError(fmt::format(
        "tracking: the covariance of the odometry at {} s is not symmetric and positive", time_s));
  }
  covariance_last_ = covariance;
  if (!T_odom_last_) {
    T_odom_last_ = T_odom_lidar;
    time_s_ = time_s;
    return pose();
  }
  if (time_s < time_s_) {
    throw UserError(fmt::format("tracking: odometry at {} s comes after {} s", time_s, time_s_));
  }
  // Track and rivals move with the odometry.
  const Pose2 T_last_now = T_odom_last_->inverse() * T_odom_lidar;
  const double duration_s = time_s - time_s_;
  const OdometryStep step = odometry_step(T_last_now, duration_s, covariance, settings_);
  if (track_) track_->move(step);
  for (Rival& rival : rivals_) rival.filter.move(step);
  travelled_m_ += T_last_now.translation_m.norm();
  T_odom_last_ = T_odom_lidar;
  time_s_ = time_s;
  if (state_ == TrackState::kTracking && time_s - last_fix_s_ > settings_.coasting_after_s) {
    state_ = TrackState::kCoasting;
    report(TrackEvent::Kind::kCoasting);
  }
  return pose();
}

FixUse PoseTracker::add_fix(const TrackFix& fix) {
  if (!T_odom_last_) throw UserError("tracking: a localization before the first odometry");
  const bool usable = std::isfinite(fix.time_s) && is_finite_pose(fix.T_odom_lidar) &&
                      is_finite_pose(fix.T_map_local) &&
                      (!fix.covariance || is_proper_covariance(*fix.covariance));
  if (!usable) return FixUse::kRefused;
  const Belief now = carried(fix);
  if (!pose().has_pose()) return remember(now);
  if (mahalanobis_squared(track_->belief(), now) <= gate_) {
    use(now, fix.time_s);
    return FixUse::kUsed;
  }
  ++misses_;
  ++rejected_in_a_row_;
  const FixUse remembered = remember(now);
  if (remembered == FixUse::kRestart) return remembered;
  if (rejected_in_a_row_ >= settings_.lost_after) {
    state_ = TrackState::kLost;
    report(TrackEvent::Kind::kLost);
  }
  return FixUse::kRejected;
}

/// The fix at the last scan, with all of its error.
Belief PoseTracker::carried(const TrackFix& fix) const {
  const auto variances = [](double metres, double degrees) -> Eigen::Vector3d {
    const double yaw_rad = deg_to_rad(degrees);
    return {metres * metres, metres * metres, yaw_rad * yaw_rad};
  };
  const Eigen::Matrix3d stated =
      variances(settings_.fix_sigma_m, settings_.fix_sigma_deg).asDiagonal();
  Belief belief{fix.T_map_local, fix.covariance.value_or(stated)};
  belief.covariance.diagonal() += variances(settings_.map_sigma_m, settings_.map_sigma_deg);
  const Pose2 T_fix_now = fix.T_odom_lidar.inverse() * *T_odom_last_;
  const double duration_s = std::max(time_s_ - fix.time_s, 0.0);
  return moved(belief, carrying_step(T_fix_now, duration_s, covariance_last_, settings_));
}

/// Fixes of one stretch of way see the same stems, and share their errors: of n in
/// `shared_length_m`, each counts 1/n.
Belief PoseTracker::weakened(const Belief& fix) const {
  constexpr double kLeastWay_m = 1e-3;  // at rest a fix tells next to nothing new
  const double way_m = std::max(travelled_m_ - last_fix_travelled_m_, kLeastWay_m);
  Belief weak = fix;
  weak.covariance *= std::max(settings_.shared_length_m / way_m, 1.0);
  return weak;
}

void PoseTracker::use(const Belief& fix, double fix_time_s) {
  const Pose2 before = track_->belief().T_map_lidar;
  track_->update(weakened(fix));
  last_fix_s_ = std::max(last_fix_s_, fix_time_s);
  last_fix_travelled_m_ = travelled_m_;
  rejected_in_a_row_ = 0;
  misses_ = 0;
  rivals_.clear();
  if (state_ == TrackState::kCoasting && time_s_ - last_fix_s_ <= settings_.coasting_after_s) {
    state_ = TrackState::kTracking;
    const Pose2& after = track_->belief().T_map_lidar;
    report(TrackEvent::Kind::kRecovered, (after.translation_m - before.translation_m).norm());
  }
}

/// Lets a fix found a rival or join one; a rival of enough fixes becomes the track.
FixUse PoseTracker::remember(const Belief& fix) {
  const DriftFilter begun(fix, settings_.odometry);
  Rival* rival = agreeing_rival(fix);
  if (rival == nullptr) {
    if (rivals_.size() == kMostRivals) rivals_.erase(rivals_.begin());
    rival = &rivals_.emplace_back(Rival{begun, 1, travelled_m_});
  } else if (travelled_m_ - rival->travelled_m >= settings_.confirm_distance_m) {
    *rival = {begun, rival->fixes + 1, travelled_m_};
  }
  if (rival->fixes < settings_.confirm_fixes) return FixUse::kHeld;
  restart(DriftFilter(rival->filter));
  return FixUse::kRestart;
}

/// The rival of most fixes that the fix agrees with.
PoseTracker::Rival* PoseTracker::agreeing_rival(const Belief& fix) {
  Rival* best = nullptr;
  for (Rival& rival : rivals_) {
    if (mahalanobis_squared(rival.filter.belief(), fix) > gate_) continue;
    if (best == nullptr || rival.fixes > best->fixes) best = &rival;
  }
  return best;
}

void PoseTracker::restart(const DriftFilter& filter) {
  if (state_ == TrackState::kSearching) {
    report(TrackEvent::Kind::kInitialised);
  } else {
    const Belief& before = track_->belief();
    const Belief& after = filter.belief();
    const double distance_m =
        (after.T_map_lidar.translation_m - before.T_map_lidar.translation_m).norm();
    const bool elsewhere = mahalanobis_squared(before, after) > gate_;
    if (elsewhere && distance_m > settings_.kidnapped_beyond_m) {
      report(TrackEvent::Kind::kKidnapped, distance_m);
    }
    report(TrackEvent::Kind::kRecovered, distance_m);
  }
  track_ = filter;
  state_ = TrackState::kTracking;
  last_fix_s_ = time_s_;
  last_fix_travelled_m_ = travelled_m_;
  rejected_in_a_row_ = 0;
  misses_ = 0;
  rivals_.clear();
}

void PoseTracker::report(TrackEvent::Kind kind, double distance_m) {
  events_.push_back({time_s_, kind, distance_m});
}

std::optional<LocatePrior> PoseTracker::prior() const {
  if (!pose().has_pose() || misses_ >= settings_.prior_misses) return std::nullopt;
  const double radius_m =
      3.0 * largest_position_sigma_m(track_->belief()) + settings_.prior_floor_m;
  return LocatePrior{track_->belief().T_map_lidar.translation_m, radius_m};
}

TrackedPose PoseTracker::pose() const {
  const Belief belief = track_ ? track_->belief() : Belief{};
  return {time_s_, state_, belief, std::max(time_s_ - last_fix_s_, 0.0)};
}

}  // namespace honka
