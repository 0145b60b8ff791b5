#include "eval/run/truth_noise_odometry.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "algo/geometry/se3.h"
#include "algo/types/random.h"

namespace honka::eval {

namespace {

Eigen::Matrix3d rotation_of(double roll_rad, double pitch_rad, double yaw_rad) {
  return pose_from_rpy(Eigen::Vector3d::Zero(), roll_rad, pitch_rad, yaw_rad).linear();
}

}  // namespace

/// Drift in units of its s.d.: x, y and yaw.
class TruthNoiseOdometry::Drift {
 public:
  virtual ~Drift() = default;
  /// For the sweeps of a drive, one after the other.
  [[nodiscard]] virtual Eigen::Vector3d at(const Eigen::Vector3d& place_m) = 0;
};

/// First-order Gauss–Markov over the way travelled.
class TruthNoiseOdometry::DriftAlongWay : public Drift {
 public:
  DriftAlongWay(std::uint64_t seed, double length_m)
      : stream_(seed, "odometry_drift"), length_m_(length_m) {
    for (int axis = 0; axis < 3; ++axis) state_[axis] = stream_.normal();
  }
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& place_m) override {
    const double way_m = last_m_ ? (place_m - *last_m_).norm() : 0.0;
    const double memory = std::exp(-way_m / length_m_);
    const double fresh = std::sqrt(std::max(0.0, 1.0 - memory * memory));
    for (int axis = 0; axis < 3; ++axis) {
      state_[axis] = memory * state_[axis] + fresh * stream_.normal();
    }
    last_m_ = place_m;
    return state_;
  }

 private:
  RandomStream stream_;
  double length_m_;
  Eigen::Vector3d state_;
  std::optional<Eigen::Vector3d> last_m_;
};

/// Gaussian field over the plane with covariance exp(−distance / length), as a sum of waves drawn
/// from its spectrum (Rahimi & Recht 2007): |k| has the distribution 1 − (1 + (length
/// |k|)²)^(−1/2).
class TruthNoiseOdometry::DriftOfPlace : public Drift {
 public:
  DriftOfPlace(std::uint64_t seed, double length_m) {
    for (std::size_t i = 0; i < kWaves; ++i) {
      RandomStream stream(seed, "odometry_drift_wave", {i});
      for (int axis = 0; axis < 3; ++axis) {
        const double rest = 1.0 - stream.uniform();
        const double k = std::sqrt(1.0 / (rest * rest) - 1.0) / length_m;
        const double direction = stream.uniform(0.0, 2.0 * kPi);
        waves_.push_back(
            {k * std::cos(direction), k * std::sin(direction), stream.uniform(0.0, 2.0 * kPi)});
      }
    }
  }
  [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector3d& place_m) override {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < waves_.size(); ++i) {
      const Wave& wave = waves_[i];
      sum[static_cast<Eigen::Index>(i % 3)] +=
          std::cos(wave.x * place_m.x() + wave.y * place_m.y() + wave.phase);
    }
    return sum * std::sqrt(2.0 / static_cast<double>(kWaves));
  }

 private:
  static constexpr std::size_t kWaves = 200;
  struct Wave {
    double x, y, phase;
  };
  std::vector<Wave> waves_;
};

TruthNoiseOdometry::TruthNoiseOdometry(const sim::Trajectory& truth, double period_s,
                                       std::int64_t sweeps, const OdometrySettings& settings,
                                       std::uint64_t seed)
    : truth_(truth), period_s_(period_s), sweeps_(sweeps), settings_(settings), seed_(seed) {
  if (settings.drift_follows == "way") {
    drift_ = std::make_unique<DriftAlongWay>(seed, settings.correlation_length_m);
  } else {
    drift_ = std::make_unique<DriftOfPlace>(seed, settings.correlation_length_m);
  }
  const double angle_sd_rad = deg_to_rad(settings.jitter_deg);
  Twist variances;
  variances << Eigen::Vector3d::Constant(settings.jitter_m * settings.jitter_m),
      Eigen::Vector3d::Constant(angle_sd_rad * angle_sd_rad);
  covariance_ = variances.asDiagonal();
}

TruthNoiseOdometry::~TruthNoiseOdometry() = default;

const TruthNoiseOdometry::Error& TruthNoiseOdometry::error_of(std::int64_t sweep) const {
  const double angle_sd_rad = deg_to_rad(settings_.jitter_deg);
  for (auto k = static_cast<std::int64_t>(errors_.size()); k <= sweep; ++k) {
    const double time_s = period_s_ * static_cast<double>(k);
    const Eigen::Vector3d drifted = drift_->at(truth_.T_world_lidar(time_s).translation());
    RandomStream jitter(seed_, "odometry_jitter", {static_cast<std::uint64_t>(k)});
    Error error;
    for (int axis = 0; axis < 3; ++axis) {
      error.translation_m[axis] = jitter.normal(0.0, settings_.jitter_m);
    }
    error.translation_m.head<2>() += settings_.drift_m * drifted.head<2>();
    const double roll = jitter.normal(0.0, angle_sd_rad);
    const double pitch = jitter.normal(0.0, angle_sd_rad);
    const double yaw =
        jitter.normal(0.0, angle_sd_rad) + deg_to_rad(settings_.drift_deg) * drifted.z();
    error.rotation = rotation_of(roll, pitch, yaw);
    errors_.push_back(error);
  }
  return errors_[static_cast<std::size_t>(sweep)];
}

OdometryCause TruthNoiseOdometry::place_in_time(double start_time_s) const {
  if (!std::isfinite(start_time_s)) return OdometryCause::kNotFinite;
  if (!started_ || start_time_s > last_.start_time_s) return OdometryCause::kNone;
  return start_time_s < last_.start_time_s ? OdometryCause::kReversedTime
                                           : OdometryCause::kRepeatedTime;
}

OdometryEstimate TruthNoiseOdometry::process(const Sweep& sweep) {
  OdometryEstimate estimate = last_;
  estimate.sweep = sweep.index;
  estimate.cause = place_in_time(sweep.start_time_s);
  estimate.covariance = covariance_;
  if (estimate.cause != OdometryCause::kNone || sweeps_ == 0) {
    estimate.status = OdometryStatus::kRefused;
    estimate.T_odom_start = last_.T_odom_end;
    return estimate;
  }
  const std::int64_t nearest = std::clamp<std::int64_t>(sweep.index, 0, sweeps() - 1);
  estimate.start_time_s = sweep.start_time_s;
  estimate.end_time_s = sweep.start_time_s + period_s_;
  estimate.T_odom_start = T_odom_lidar(nearest, estimate.start_time_s);
  estimate.T_odom_end = T_odom_lidar(nearest, estimate.end_time_s);
  last_ = estimate;
  started_ = true;
  return estimate;
}

Pose3 TruthNoiseOdometry::T_odom_lidar(std::int64_t sweep, double time_s) const {
  const Error& error = error_of(sweep);
  const Pose3 T_world_lidar = truth_.T_world_lidar(time_s);
  Pose3 T_odom_lidar = Pose3::Identity();
  T_odom_lidar.translation() = T_world_lidar.translation() + error.translation_m;
  T_odom_lidar.linear() = error.rotation * T_world_lidar.linear();
  return T_odom_lidar;
}

}  // namespace honka::eval
