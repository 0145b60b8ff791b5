#include "algo/localize/consensus/pose_estimate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "algo/localize/consensus/partners.h"

namespace honka {
namespace {

/// Of the unknowns: shift of the sensor along its own axes, turn, radial bias.
using Unknowns = Eigen::Vector4d;
using Information = Eigen::Matrix4d;

constexpr double kMostSigma_m = 1.0;
constexpr double kSamePlace_m = 1.0;  // from the settled fit
constexpr double kMostBias_m = 0.3;   // plain means of one-sided views: 0.79 of a stem's radius

struct Estimate {
  Placement T_map_sensor;
  double radial_bias_m = 0.0, sigma_m = 0.0, false_share = 0.3;
  Information given_partners = Information::Zero();  ///< times σ²
  Information lost = Information::Zero();            ///< times σ⁴: partners are not given
  bool biased = false;

  /// Whole or, where the loss takes too much of it, that of given partners.
  [[nodiscard]] Information covariance() const {
    const double variance = sigma_m * sigma_m;
    const Information whole = given_partners / variance - lost / (variance * variance);
    const Eigen::LLT<Information> roots(whole);
    if (roots.info() == Eigen::Success) return roots.solve(Information::Identity());
    return variance * given_partners.ldlt().solve(Information::Identity());
  }
};

/// A local stem with the map stems around it.
struct SeenStem {
  Eigen::Vector2d in_sensor_m, along;  ///< place; unit vector of the line of sight
};

class MixtureFit {
 public:
  MixtureFit(const Judge& judge, const Eigen::Vector2d& sensor_in_frame_m) : judge_(judge) {
    for (const Eigen::Vector2d& q : judge.stems()) {
      const Eigen::Vector2d place_m = q - sensor_in_frame_m;
      seen_.push_back({place_m, place_m.stableNormalized()});
    }
  }

  /// Partners and unknowns in turns until nothing moves.
  [[nodiscard]] std::optional<Estimate> run(Estimate at) {
    constexpr int kMostTurns = 60;
    constexpr double kGatherAgain_m = 0.1;
    const Eigen::Vector2d start_m = at.T_map_sensor.shift_m;
    double since_gathered_m = 1.0;
    for (int turn = 0; turn < kMostTurns; ++turn) {
      if (since_gathered_m > kGatherAgain_m) {
        gather(at);
        since_gathered_m = 0.0;
      }
      weigh_pairs(at);
      const double moved_m = improve(at);
      const double away_m = (at.T_map_sensor.shift_m - start_m).norm();
      const bool holds = away_m < kSamePlace_m && std::abs(at.radial_bias_m) < kMostBias_m;
      if (!holds) return std::nullopt;
      if (moved_m < 1e-9) break;
      since_gathered_m += moved_m;
    }
    return at;
  }

 private:
  [[nodiscard]] Eigen::Vector2d unbiased(const SeenStem& seen, const Estimate& at) const {
    return seen.in_sensor_m + at.radial_bias_m * seen.along;
  }

  /// The map stems that a local stem may be.
  void gather(const Estimate& at) {
    constexpr double kReachSigmas = 4.5;
    constexpr double kFarthest_m = 3.0;
    const double reach_m = std::min(kReachSigmas * at.sigma_m + 0.1, kFarthest_m);
    pairs_.clear();
    map_.clear();
    for (std::uint32_t i = 0; i < seen_.size(); ++i) {
      judge_.index().grid().within(
          at.T_map_sensor * unbiased(seen_[i], at), reach_m, [&](std::uint32_t stem) {
            const auto known = std::find(map_.begin(), map_.end(), stem);
            pairs_.push_back({i, static_cast<std::uint32_t>(known - map_.begin()), 0.0, 0.0});
            if (known == map_.end()) map_.push_back(stem);
          });
    }
    residuals_m_.resize(pairs_.size());
  }

  /// Residuals in the sensor's axes, and how probable each pair is.
  void weigh_pairs(const Estimate& at) {
    constexpr double kListedShare = 0.5;  // of the mapped stems around; 0.8 measures alike
    const double variance = at.sigma_m * at.sigma_m;
    const double true_over_false = (1.0 - at.false_share) / at.false_share / (1.0 - kListedShare);
    const Placement& T = at.T_map_sensor;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const std::uint32_t stem = map_[pairs_[k].map];
      const Eigen::Vector2d d = judge_.index().grid().stems()[stem] - T.shift_m;
      const Eigen::Vector2d mapped(T.cosine * d.x() + T.sine * d.y(),
                                   T.cosine * d.y() - T.sine * d.x());
      residuals_m_[k] = mapped - unbiased(seen_[pairs_[k].local], at);
      const double density = judge_.index().groups().densities()[stem];
      pairs_[k].odds = true_over_false * std::exp(-0.5 * residuals_m_[k].squaredNorm() / variance) /
                       (2.0 * std::numbers::pi * variance * density);
    }
    share_partners(pairs_, map_.size());
  }

  /// One Gauss–Newton step of the expected squares, then σ and the share of false stems; returns
  /// how far it moved.
  double improve(Estimate& at) const {
    at.given_partners.setZero();
    at.lost.setZero();
    Unknowns pull = Unknowns::Zero();
    double weight = 0.0;
    double squares_m2 = 0.0;
    for (std::size_t k = 0; k < pairs_.size();) {
      const std::uint32_t local = pairs_[k].local;
      const Eigen::Vector2d place = unbiased(seen_[local], at);
      const Eigen::Vector2d along = at.biased ? seen_[local].along : Eigen::Vector2d::Zero();
      Eigen::Matrix<double, 2, 4> moved;
      moved << 1.0, 0.0, -place.y(), along.x(), 0.0, 1.0, place.x(), along.y();
      double own = 0.0;
      Eigen::Vector2d mean = Eigen::Vector2d::Zero();
      Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
      for (; k < pairs_.size() && pairs_[k].local == local; ++k) {
        const double p = pairs_[k].probability;
        own += p;
        mean += p * residuals_m_[k];
        scatter += p * residuals_m_[k] * residuals_m_[k].transpose();
      }
      weight += own;
      squares_m2 += scatter.trace();
      pull += moved.transpose() * mean;
      at.given_partners += own * moved.transpose() * moved;
      at.lost += moved.transpose() * (scatter - mean * mean.transpose()) * moved;
    }
    if (!at.biased) at.given_partners(3, 3) = 1.0;
    const Unknowns step = at.given_partners.ldlt().solve(pull);
    return apply(at, step) + update_noise(at, weight, squares_m2 - step.dot(pull));
  }

  static double apply(Estimate& at, const Unknowns& step) {
    Placement& T = at.T_map_sensor;
    T.shift_m += T.turned(step.head<2>());
    const Eigen::Vector2d ahead = T.turned({std::cos(step(2)), std::sin(step(2))});
    T.cosine = ahead.x();
    T.sine = ahead.y();
    at.radial_bias_m += step(3);
    constexpr double kArm_m = 30.0;
    return step.head<2>().norm() + kArm_m * std::abs(step(2)) + std::abs(step(3));
  }

  /// σ with the weight of one stem at the noise of the settings, the share of false stems with that
  /// of two stems at three in ten.
  double update_noise(Estimate& at, double weight, double squares_m2) const {
    const ConsensusSettings& settings = judge_.settings();
    constexpr double kPriorAxes = 2.0;
    const double prior_m2 = settings.stem_sigma_m * settings.stem_sigma_m;
    const double fitted = at.biased ? 4.0 : 3.0;
    const double variance = (kPriorAxes * prior_m2 + std::max(squares_m2, 0.0)) /
                            (kPriorAxes + std::max(2.0 * weight - fitted, 1.0));
    const double before_m = at.sigma_m;
    at.sigma_m = std::clamp(std::sqrt(variance), settings.sigma_floor_m, kMostSigma_m);
    const double stems = static_cast<double>(seen_.size());
    at.false_share = (0.6 + stems - weight) / (2.0 + stems);
    return std::abs(at.sigma_m - before_m);
  }

  const Judge& judge_;
  std::vector<SeenStem> seen_;
  std::vector<std::uint32_t> map_;  ///< index of the grid, of each stem that `map` counts
  std::vector<PossiblePair> pairs_;
  std::vector<Eigen::Vector2d> residuals_m_;
};

/// From the sensor's axes to those of the map.
Eigen::Matrix3d turned_covariance(const Placement& T, const Eigen::Matrix3d& covariance) {
  Eigen::Matrix3d turn;
  turn << T.cosine, -T.sine, 0.0, T.sine, T.cosine, 0.0, 0.0, 0.0, 1.0;
  return turn * covariance * turn.transpose();
}

}  // namespace

std::optional<PoseEstimate> estimate_pose(const Judge& judge,
                                          const Eigen::Vector2d& sensor_in_frame_m,
                                          const Fit& start) {
  MixtureFit fit(judge, sensor_in_frame_m);
  Estimate first;
  first.T_map_sensor = start.placement;
  first.T_map_sensor.shift_m = start.placement * sensor_in_frame_m;
  first.sigma_m = start.sigma_m;

  // Three unknowns; a fourth where it is certain
  auto best = fit.run(first);
  if (!best) return std::nullopt;
  Estimate with_bias = *best;
  with_bias.biased = true;
  if (const auto four = fit.run(with_bias)) {
    const double least_m = judge.settings().radial_bias_sds * std::sqrt(four->covariance()(3, 3));
    if (std::abs(four->radial_bias_m) >= least_m) best = four;
  }

  PoseEstimate answer;
  answer.T_map_sensor = best->T_map_sensor;
  answer.sigma_m = best->sigma_m;
  answer.false_share = best->false_share;
  answer.radial_bias_m = best->radial_bias_m;
  answer.covariance =
      turned_covariance(best->T_map_sensor, best->covariance().topLeftCorner<3, 3>());
  return answer;
}

}  // namespace honka
