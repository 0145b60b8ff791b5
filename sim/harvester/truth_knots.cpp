#include "sim/harvester/truth_knots.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algo/types/random.h"

namespace honka::sim {
namespace {

/// The front body on the ground: place of the joint, heading, gradient of the ground under it.
struct Stand {
  Eigen::Vector2d joint_m;
  double yaw_rad = 0.0;
  double z_m = 0.0;          ///< ground under the joint
  Eigen::Vector2d gradient;  ///< of the ground, world frame
};

/// Least-squares plane through the ground under the front body, 5 × 3 samples.
void fit_ground(Stand& stand, const Heightfield& terrain, const VehicleSettings& settings) {
  const Eigen::Vector2d ahead(std::cos(stand.yaw_rad), std::sin(stand.yaw_rad));
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const double dx = settings.front_length_m / 4, dy = settings.track_width_m / 2;
  double sum = 0.0, sum_x = 0.0, sum_y = 0.0;
  for (int i = -2; i <= 2; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const double z = terrain.height_m(stand.joint_m + (i + 2) * dx * ahead + j * dy * left);
      sum += z;
      sum_x += i * z;
      sum_y += j * z;
    }
  }
  const double slope_x = sum_x / (30.0 * dx);  // 3 Σ i² = 30
  const double slope_y = sum_y / (10.0 * dy);  // 5 Σ j² = 10
  stand.gradient = slope_x * ahead + slope_y * left;
  stand.z_m = sum / 15.0 - slope_x * 2.0 * dx;
}

/// Gaussian mean over time of the gradients: the springs do not follow each stone.
void smooth_gradients(std::vector<Stand>& stands) {
  constexpr double kSigma_s = 0.2;
  constexpr int kReach = static_cast<int>(3.0 * kSigma_s / kTruthKnot_s);
  std::array<double, kReach + 1> weight;
  double total = 0.0;
  for (int k = 0; k <= kReach; ++k) {
    const double x = k * kTruthKnot_s / kSigma_s;
    weight[static_cast<std::size_t>(k)] = std::exp(-0.5 * x * x);
    total += (k == 0 ? 1.0 : 2.0) * weight[static_cast<std::size_t>(k)];
  }
  std::vector<Eigen::Vector2d> raw;
  raw.reserve(stands.size());
  for (const Stand& stand : stands) raw.push_back(stand.gradient);
  const auto last = static_cast<int>(stands.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (int k = -kReach; k <= kReach; ++k) {
      sum += weight[static_cast<std::size_t>(std::abs(k))] *
             raw[static_cast<std::size_t>(std::clamp(i + k, 0, last))];
    }
    stands[static_cast<std::size_t>(i)].gradient = sum / total;
  }
}

/// Roll or pitch on the springs: waves of 0.3 to 1.5 Hz with the asked variance in all.
class Suspension {
 public:
  Suspension(double sigma_rad, std::string_view name, std::uint64_t seed) {
    RandomStream stream(seed, name);
    for (Wave& wave : waves_) {
      wave = {sigma_rad * std::sqrt(2.0 / static_cast<double>(waves_.size())),
              2.0 * kPi * stream.uniform(0.3, 1.5), stream.uniform(0.0, 2.0 * kPi)};
    }
  }
  [[nodiscard]] double at(double time_s) const {
    double sum = 0.0;
    for (const Wave& w : waves_) sum += w.amplitude * std::sin(w.rate * time_s + w.phase);
    return sum;
  }

 private:
  struct Wave {
    double amplitude, rate, phase;
  };
  std::array<Wave, 6> waves_;
};

/// Rotation of a body that stands on a plane of this gradient, after a roll and pitch of its own.
Eigen::Matrix3d body_rotation(const Stand& stand, double roll_rad, double pitch_rad) {
  const double c = std::cos(stand.yaw_rad), s = std::sin(stand.yaw_rad);
  const double rise_ahead = c * stand.gradient.x() + s * stand.gradient.y();
  const double rise_left = c * stand.gradient.y() - s * stand.gradient.x();
  // The body's z axis is the plane's normal (−rise_ahead, −rise_left, 1), scaled.
  const double pitch = -std::atan(rise_ahead);
  const double roll = std::atan(rise_left / std::hypot(1.0, rise_ahead));
  return pose_from_rpy({0, 0, 0}, roll + roll_rad, pitch + pitch_rad, stand.yaw_rad).linear();
}

PoseKnot knot_of(const Stand& stand, const Eigen::Matrix3d& R_world_body,
                 const VehicleSettings& settings, double yaw_near_rad) {
  const Eigen::Vector3d arm(settings.joint_to_lidar_m, 0.0, settings.sensor_height_m);
  const Eigen::Vector3d place =
      Eigen::Vector3d(stand.joint_m.x(), stand.joint_m.y(), stand.z_m) + R_world_body * arm;
  const Eigen::Matrix3d R =
      R_world_body * pose_from_rpy({0, 0, 0}, deg_to_rad(settings.mount_roll_deg),
                                   deg_to_rad(settings.mount_pitch_deg), 0.0)
                         .linear();
  const double yaw = std::atan2(R(1, 0), R(0, 0));
  return {place.x(),
          place.y(),
          place.z(),
          std::atan2(R(2, 1), R(2, 2)),
          -std::asin(std::clamp(R(2, 0), -1.0, 1.0)),
          yaw_near_rad + wrap_to_pi(yaw - yaw_near_rad)};
}

}  // namespace

double driving_direction_rad(const SmoothPath& path, double along_m, double front_length_m) {
  const Eigen::Vector2d chord = path.at(along_m + front_length_m) - path.at(along_m);
  return std::atan2(chord.y(), chord.x());
}

std::vector<PoseKnot> truth_knots(const SmoothPath& path, const WorkPlan& plan,
                                  const Heightfield& terrain, const VehicleSettings& settings,
                                  std::uint64_t seed) {
  const auto count = static_cast<std::size_t>(std::ceil(plan.duration_s() / kTruthKnot_s)) + 1;
  std::vector<Stand> stands(std::max<std::size_t>(count, 2));
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const double time = kTruthKnot_s * static_cast<double>(i);
    const double along = plan.travelled_m(time);
    stands[i].joint_m = path.at(along);
    stands[i].yaw_rad =
        driving_direction_rad(path, along, settings.front_length_m) + plan.swing_rad(time);
    fit_ground(stands[i], terrain, settings);
  }
  smooth_gradients(stands);
  const double sigma = deg_to_rad(settings.suspension_noise_deg);
  const Suspension roll(sigma, "vehicle_roll", seed), pitch(sigma, "vehicle_pitch", seed);
  std::vector<PoseKnot> knots;
  knots.reserve(stands.size());
  double yaw = 0.0;
  for (std::size_t i = 0; i < stands.size(); ++i) {
    const double time = kTruthKnot_s * static_cast<double>(i);
    knots.push_back(
        knot_of(stands[i], body_rotation(stands[i], roll.at(time), pitch.at(time)), settings, yaw));
    yaw = knots.back()[5];
  }
  return knots;
}

}  // namespace honka::sim
