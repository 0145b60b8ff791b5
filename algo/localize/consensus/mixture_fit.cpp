#include "algo/localize/consensus/mixture_fit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace honka {
namespace {

constexpr double kMostSigma_m = 1.0;
constexpr double kMostBias_m = 0.3;   // plain means of one-sided views: 0.79 of a stem's radius
constexpr double kMostStrain = 0.25;  // a slope of 40 degrees
/// From the settled fit; a strained list lies askew on the map, and its sensor beside its place.
constexpr double same_place_m(int unknowns) { return unknowns == kWithStrain ? 5.0 : 1.0; }

bool holds(const MixtureState& at, double away_m, int unknowns) {
  return away_m < same_place_m(unknowns) && std::abs(at.radial_bias_m) < kMostBias_m &&
         at.strain.cwiseAbs().maxCoeff() < kMostStrain;
}

}  // namespace

/// One Gauss–Newton step of the expected squares, and what it was made from.
template <int N>
struct MixtureFit::Step {
  Eigen::Matrix<double, N, 1> unknowns, pull = Eigen::Matrix<double, N, 1>::Zero();
  double weight = 0.0, squares_m2 = 0.0;
};

MixtureFit::MixtureFit(const Judge& judge, const Eigen::Vector2d& sensor_in_frame_m)
    : judge_(judge) {
  for (const Eigen::Vector2d& q : judge.stems()) {
    const Eigen::Vector2d place_m = q - sensor_in_frame_m;
    seen_.push_back({place_m, place_m.stableNormalized()});
  }
}

template <int N>
std::optional<MixtureEstimate<N>> MixtureFit::run(const MixtureState& start) {
  constexpr int kMostTurns = 60;
  constexpr double kGatherAgain_m = 0.1;
  MixtureEstimate<N> at(start);
  double since_gathered_m = 1.0;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    if (since_gathered_m > kGatherAgain_m) {
      gather(at);
      since_gathered_m = 0.0;
    }
    weigh_pairs(at);
    const double moved_m = improve(at);
    const double away_m = (at.T_map_sensor.shift_m - start.T_map_sensor.shift_m).norm();
    if (!holds(at, away_m, N)) return std::nullopt;
    if (moved_m < 1e-9) break;
    since_gathered_m += moved_m;
  }
  return at;
}

double MixtureFit::strain_squared_sds(const MixtureState& state) {
  MixtureEstimate<kWithStrain> at(state);
  gather(at);
  weigh_pairs(at);
  const Step<kWithStrain> step = step_from(at);
  const Eigen::Matrix3d covariance = at.covariance().template bottomRightCorner<3, 3>();
  const Eigen::Vector3d strain = step.unknowns.template tail<3>();
  return strain.dot(covariance.ldlt().solve(strain));
}

Eigen::Vector2d MixtureFit::corrected(const SeenStem& seen, const MixtureState& at) {
  const Eigen::Vector2d& q = seen.in_sensor_m;
  const Eigen::Vector2d place_m = q + at.radial_bias_m * seen.along;
  if (at.strain.isZero(0.0)) return place_m;
  return place_m + Eigen::Vector2d(at.strain(0) * q.x() + at.strain(2) * q.y(),
                                   at.strain(2) * q.x() + at.strain(1) * q.y());
}

/// The map stems that a local stem may be.
void MixtureFit::gather(const MixtureState& at) {
  constexpr double kReachSigmas = 4.5;
  constexpr double kFarthest_m = 3.0;
  const double reach_m = std::min(kReachSigmas * at.sigma_m + 0.1, kFarthest_m);
  pairs_.clear();
  map_.clear();
  for (std::uint32_t i = 0; i < seen_.size(); ++i) {
    judge_.index().grid().within(
        at.T_map_sensor * corrected(seen_[i], at), reach_m, [&](std::uint32_t stem) {
          const auto known = std::find(map_.begin(), map_.end(), stem);
          pairs_.push_back({i, static_cast<std::uint32_t>(known - map_.begin()), 0.0, 0.0});
          if (known == map_.end()) map_.push_back(stem);
        });
  }
  residuals_m_.resize(pairs_.size());
}

/// Residuals in the sensor's axes, and how probable each pair is.
void MixtureFit::weigh_pairs(const MixtureState& at) {
  constexpr double kListedShare = 0.5;  // of the mapped stems around; 0.8 measures alike
  const double variance = at.sigma_m * at.sigma_m;
  const double true_over_false = (1.0 - at.false_share) / at.false_share / (1.0 - kListedShare);
  const Placement& T = at.T_map_sensor;
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    const std::uint32_t stem = map_[pairs_[k].map];
    const Eigen::Vector2d d = judge_.index().grid().stems()[stem] - T.shift_m;
    const Eigen::Vector2d mapped(T.cosine * d.x() + T.sine * d.y(),
                                 T.cosine * d.y() - T.sine * d.x());
    residuals_m_[k] = mapped - corrected(seen_[pairs_[k].local], at);
    const double density = judge_.index().groups().densities()[stem];
    pairs_[k].odds = true_over_false * std::exp(-0.5 * residuals_m_[k].squaredNorm() / variance) /
                     (2.0 * std::numbers::pi * variance * density);
  }
  share_partners(pairs_, map_.size());
}

template <int N>
MixtureFit::Step<N> MixtureFit::step_from(MixtureEstimate<N>& at) const {
  at.given_partners.setZero();
  at.lost.setZero();
  Step<N> step;
  for (std::size_t k = 0; k < pairs_.size();) {
    const std::uint32_t local = pairs_[k].local;
    const Eigen::Vector2d place = corrected(seen_[local], at);
    const Eigen::Vector2d along = at.biased ? seen_[local].along : Eigen::Vector2d::Zero();
    Eigen::Matrix<double, 2, N> moved;
    moved.template leftCols<4>() << 1.0, 0.0, -place.y(), along.x(),  //
        0.0, 1.0, place.x(), along.y();
    if constexpr (N == kWithStrain) {
      const Eigen::Vector2d& q = seen_[local].in_sensor_m;
      moved.template rightCols<3>() << q.x(), 0.0, q.y(), 0.0, q.y(), q.x();
    }
    double own = 0.0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (; k < pairs_.size() && pairs_[k].local == local; ++k) {
      const double p = pairs_[k].probability;
      own += p;
      mean += p * residuals_m_[k];
      scatter += p * residuals_m_[k] * residuals_m_[k].transpose();
    }
    step.weight += own;
    step.squares_m2 += scatter.trace();
    step.pull += moved.transpose() * mean;
    at.given_partners += own * moved.transpose() * moved;
    at.lost += moved.transpose() * (scatter - mean * mean.transpose()) * moved;
  }
  if (!at.biased) at.given_partners(3, 3) = 1.0;
  step.unknowns = at.given_partners.ldlt().solve(step.pull);
  return step;
}

/// A step, then σ and the share of false stems; returns how far it moved.
template <int N>
double MixtureFit::improve(MixtureEstimate<N>& at) const {
  constexpr double kArm_m = 30.0;
  const Step<N> step = step_from(at);
  const auto& u = step.unknowns;
  Placement& T = at.T_map_sensor;
  T.shift_m += T.turned(u.template head<2>());
  const Eigen::Vector2d ahead = T.turned({std::cos(u(2)), std::sin(u(2))});
  T.cosine = ahead.x();
  T.sine = ahead.y();
  at.radial_bias_m += u(3);
  double moved_m = u.template head<2>().norm() + kArm_m * std::abs(u(2)) + std::abs(u(3));
  if constexpr (N == kWithStrain) {
    at.strain += u.template tail<3>();
    moved_m += kArm_m * u.template tail<3>().norm();
  }
  const double fitted = (at.biased ? 4.0 : 3.0) + (N - kWithoutStrain);
  return moved_m + update_noise(at, fitted, step.weight, step.squares_m2 - u.dot(step.pull));
}

/// σ with the weight of one stem at the noise of the settings, the share of false stems with that
/// of two stems at three in ten.
double MixtureFit::update_noise(MixtureState& at, double fitted, double weight,
                                double squares_m2) const {
  const ConsensusSettings& settings = judge_.settings();
  constexpr double kPriorAxes = 2.0;
  const double prior_m2 = settings.stem_sigma_m * settings.stem_sigma_m;
  const double variance = (kPriorAxes * prior_m2 + std::max(squares_m2, 0.0)) /
                          (kPriorAxes + std::max(2.0 * weight - fitted, 1.0));
  const double before_m = at.sigma_m;
  at.sigma_m = std::clamp(std::sqrt(variance), settings.sigma_floor_m, kMostSigma_m);
  const double stems = static_cast<double>(seen_.size());
  at.false_share = (0.6 + stems - weight) / (2.0 + stems);
  return std::abs(at.sigma_m - before_m);
}

template std::optional<MixtureEstimate<kWithoutStrain>> MixtureFit::run(const MixtureState&);
template std::optional<MixtureEstimate<kWithStrain>> MixtureFit::run(const MixtureState&);

}  // namespace honka
