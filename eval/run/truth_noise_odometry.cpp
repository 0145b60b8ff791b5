#include "eval/run/truth_noise_odometry.h"

#include <cmath>

#include "algo/types/random.h"

namespace honka::eval {

namespace {

Eigen::Matrix3d rotation_of(double roll_rad, double pitch_rad, double yaw_rad) {
  return pose_from_rpy(Eigen::Vector3d::Zero(), roll_rad, pitch_rad, yaw_rad).linear();
}

}  // namespace

TruthNoiseOdometry::TruthNoiseOdometry(const sim::Trajectory& truth, double period_s,
                                       std::int64_t sweeps, const OdometrySettings& settings,
                                       std::uint64_t seed)
    : truth_(truth) {
  RandomStream drift(seed, "odometry_drift");
  Eigen::Vector3d state(drift.normal(), drift.normal(), drift.normal());
  Eigen::Vector3d previous_m = truth.T_world_lidar(0.0).translation();
  for (std::int64_t k = 0; k < sweeps; ++k) {
    // Gauss–Markov drift over the distance travelled since the last sweep.
    const Eigen::Vector3d here_m =
        truth.T_world_lidar(period_s * static_cast<double>(k)).translation();
    const double memory = std::exp(-(here_m - previous_m).norm() / settings.correlation_length_m);
    const double fresh = std::sqrt(std::max(0.0, 1.0 - memory * memory));
    for (int axis = 0; axis < 3; ++axis) {
      state[axis] = memory * state[axis] + fresh * drift.normal();
    }
    previous_m = here_m;

    RandomStream jitter(seed, "odometry_jitter", {static_cast<std::uint64_t>(k)});
    const double angle_sd_rad = deg_to_rad(settings.jitter_deg);
    Error error;
    for (int axis = 0; axis < 3; ++axis) {
      error.translation_m[axis] = jitter.normal(0.0, settings.jitter_m);
    }
    error.translation_m.head<2>() += settings.drift_m * state.head<2>();
    const double roll = jitter.normal(0.0, angle_sd_rad);
    const double pitch = jitter.normal(0.0, angle_sd_rad);
    const double yaw =
        jitter.normal(0.0, angle_sd_rad) + deg_to_rad(settings.drift_deg) * state.z();
    error.rotation = rotation_of(roll, pitch, yaw);
    errors_.push_back(error);
  }
}

Pose3 TruthNoiseOdometry::T_odom_lidar(std::int64_t sweep, double time_s) const {
  const Error& error = errors_[static_cast<std::size_t>(sweep)];
  const Pose3 T_world_lidar = truth_.T_world_lidar(time_s);
  Pose3 T_odom_lidar = Pose3::Identity();
  T_odom_lidar.translation() = T_world_lidar.translation() + error.translation_m;
  T_odom_lidar.linear() = error.rotation * T_world_lidar.linear();
  return T_odom_lidar;
}

}  // namespace honka::eval
