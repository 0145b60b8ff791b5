#include "algo/localize/consensus/pose_estimate.h"

#include <cmath>

#include "algo/localize/consensus/mixture_fit.h"

namespace honka {
namespace {

/// A strain counts seven standard deviations beyond none (three numbers together), and from a part
/// in a hundred on, which is 8° of tilt: less is what noise, wrong partners and a bent map do.
constexpr double kCertainSquaredSds = 50.0;
constexpr double kLeastStrain = 0.01;

double squared_sds(const Eigen::Vector3d& strain, const Eigen::Matrix3d& covariance) {
  return strain.dot(covariance.ldlt().solve(strain));
}

/// From the sensor's axes to those of the map.
Eigen::Matrix3d turned_covariance(const Placement& T, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d turn;
  turn << T.cosine, -T.sine, 0.0, T.sine, T.cosine, 0.0, 0.0, 0.0, 1.0;
  return turn * covariance * turn.transpose();
}

/// Of the sensor's (x, y, yaw), yaw that of its x axis as it lies on the map.
template <int N>
Eigen::Matrix3d pose_covariance(const MixtureEstimate<N>& best) {
  const auto whole = best.covariance();
  if constexpr (N == kWithoutStrain) return whole.template topLeftCorner<3, 3>();
  Eigen::Matrix<double, 3, N> J = Eigen::Matrix<double, 3, N>::Identity();
  J(2, N - 1) = 1.0;  // shear turns the axis
  return J * whole * J.transpose();
}

template <int N>
PoseEstimate answer_of(const MixtureEstimate<N>& best) {
  PoseEstimate answer;
  answer.T_map_sensor = best.T_map_sensor;
  answer.sigma_m = best.sigma_m;
  answer.false_share = best.false_share;
  answer.radial_bias_m = best.radial_bias_m;
  answer.strain = best.strain;
  answer.covariance = turned_covariance(best.T_map_sensor, pose_covariance(best));
  if constexpr (N == kWithStrain) {
    const Eigen::Vector2d x_axis =
        best.T_map_sensor.turned({1.0 + best.strain(0), best.strain(2)}).normalized();
    answer.T_map_sensor.cosine = x_axis.x();
    answer.T_map_sensor.sine = x_axis.y();
  }
  return answer;
}

}  // namespace

std::optional<PoseEstimate> estimate_pose(const Judge& judge,
                                          const Eigen::Vector2d& sensor_in_frame_m,
                                          const Fit& start) {
  MixtureFit fit(judge, sensor_in_frame_m);
  MixtureState first;
  first.T_map_sensor = start.placement;
  first.T_map_sensor.shift_m = start.placement * sensor_in_frame_m;
  first.sigma_m = start.sigma_m;

  // Three unknowns; a fourth where it is certain
  auto best = fit.run<kWithoutStrain>(first);
  if (!best) return std::nullopt;
  MixtureState with_bias = *best;
  with_bias.biased = true;
  if (const auto four = fit.run<kWithoutStrain>(with_bias)) {
    const double least_m = judge.settings().radial_bias_sds * std::sqrt(four->covariance()(3, 3));
    if (std::abs(four->radial_bias_m) >= least_m) best = four;
  }

  // A strain where it is certain, looked for where a step points to it or residuals are large.
  // What is strained and cannot be fitted has no pose.
  constexpr double kLargeSigmas = 2.0;
  const bool points_to_it = fit.strain_squared_sds(*best) >= kCertainSquaredSds;
  if (!points_to_it && best->sigma_m < kLargeSigmas * judge.settings().stem_sigma_m) {
    return answer_of(*best);
  }
  const auto strained = fit.run<kWithStrain>(*best);
  if (!strained && points_to_it) return std::nullopt;
  const bool counts =
      strained && strained->strain.norm() >= kLeastStrain &&
      squared_sds(strained->strain, strained->covariance().bottomRightCorner<3, 3>()) >=
          kCertainSquaredSds;
  return counts ? answer_of(*strained) : answer_of(*best);
}

}  // namespace honka
