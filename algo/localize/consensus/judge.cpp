#include "algo/localize/consensus/judge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace honka {
namespace {

constexpr double kFalseShare = 0.3;  // of local stems; half and a tenth cost a few nats only
constexpr double kGateSigmas = 3.0;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

double gate_m(double variance_m2) {
  return std::min(kGateSigmas * std::sqrt(variance_m2), StemGrid::kWidestGate_m);
}

/// Density of the residual over the density of stems by chance.
double gain(double squared_m2, double variance_m2, double density_per_m2) {
  return std::exp(-0.5 * squared_m2 / variance_m2) / (kTwoPi * variance_m2 * density_per_m2);
}

}  // namespace

Judge::Judge(const ConsensusIndex& index, const ConsensusSettings& settings,
             std::span<const Eigen::Vector2d> stems_m, double area_m2)
    : index_(index), settings_(settings), stems_m_(stems_m), area_m2_(area_m2) {}

bool Judge::could_accept() const {
  Fit perfect;
  perfect.sigma_m = std::max(settings_.sigma_floor_m, 0.01);
  perfect.weight = static_cast<double>(stems_m_.size());
  for (const Eigen::Vector2d& q : stems_m_) perfect.spread_m2 += q.squaredNorm();
  const double variance = perfect.sigma_m * perfect.sigma_m;
  const double nats =
      perfect.weight * std::log(gain(0.0, variance, index_.grid().density_per_m2()));
  return nats - price_nats(perfect) > settings_.accept_nats;
}

std::optional<double> Judge::hear(const Fit& fit, std::span<const std::uint32_t> nearby) const {
  constexpr double kGiveUp = -3.4;  // three stems without a partner at the start
  constexpr double kLeast = 6.0;
  const double miss = std::log(kFalseShare);
  double nats = 0.0;
  for (const std::uint32_t i : nearby) {
    const Eigen::Vector2d& q = stems_m_[i];
    const double variance = fit.variance_at(q);
    const auto partner = index_.grid().nearest(fit.placement * q, gate_m(variance));
    if (partner.stem < 0) {
      nats += miss;
      if (nats < kGiveUp) return std::nullopt;
      continue;
    }
    nats += std::log(kFalseShare + (1.0 - kFalseShare) * gain(partner.squared_m2, variance,
                                                              density_at(partner.stem)));
  }
  if (nats < kLeast) return std::nullopt;
  return nats;
}

Fit Judge::improve(const Fit& fit) const {
  const Eigen::Vector2d origin = fit.placement.shift_m;
  PairSums sums;
  for (const Eigen::Vector2d& q : stems_m_) {
    const double variance = fit.variance_at(q);
    const auto partner = index_.grid().nearest(fit.placement * q, gate_m(variance));
    if (partner.stem < 0) continue;
    const double hit =
        (1.0 - kFalseShare) * gain(partner.squared_m2, variance, density_at(partner.stem));
    sums.add(q, map()[static_cast<std::size_t>(partner.stem)] - origin, hit / (kFalseShare + hit));
  }
  if (sums.weight < 2.0) return {};
  Fit next = solve(sums, origin);
  // σ with the weight of one stem at the noise of the settings; three numbers
  // were fitted.
  constexpr double kPriorAxes = 2.0;
  const double prior = settings_.stem_sigma_m * settings_.stem_sigma_m;
  const double variance = (kPriorAxes * prior + next.squares_m2) /
                          (kPriorAxes + std::max(2.0 * next.weight - 3.0, 1.0));
  next.sigma_m = std::clamp(std::sqrt(variance), settings_.sigma_floor_m, 0.6);
  return next;
}

Fit Judge::refine(const Fit& fit) const {
  constexpr int kFirstRounds = 3;
  constexpr int kRounds = 12;
  const Fit first = settle(fit, kFirstRounds);
  return first.evidence_nats > kHopeless_nats ? settle(first, kRounds) : first;
}

Fit Judge::settle(Fit fit, int rounds) const {
  for (int k = 0; k < rounds; ++k) {
    const Fit next = improve(fit);
    if (next.weight == 0.0) {
      fit.evidence_nats = -1e3;
      return fit;
    }
    const double moved = (next.placement.shift_m - fit.placement.shift_m).norm() +
                         std::abs(next.sigma_m - fit.sigma_m) +
                         10.0 * std::abs(next.placement.sine - fit.placement.sine);
    fit = next;
    if (moved < 1e-9) break;
  }
  weigh(fit);
  return fit;
}

std::uint32_t Judge::any_partner(const Fit& fit) const {
  for (const Eigen::Vector2d& q : stems_m_) {
    const auto partner = index_.grid().nearest(fit.placement * q, gate_m(fit.variance_at(q)));
    if (partner.stem >= 0) return static_cast<std::uint32_t>(partner.stem);
  }
  return 0;
}

double Judge::price_nats(const Fit& fit) const {
  // Laplace's approximation: how many places of the fit's size the map holds.
  const double variance = fit.sigma_m * fit.sigma_m;
  const double shift_m2 = variance / fit.weight;
  const double turn_rad = std::sqrt(variance / fit.spread_m2);
  return std::log(area_m2_ * kTwoPi / (std::pow(kTwoPi, 1.5) * shift_m2 * turn_rad));
}

void Judge::weigh(Fit& fit) const {
  struct Pair {
    std::int32_t map;
    double squared_m2;
  };
  std::vector<Pair> pairs;
  pairs.reserve(stems_m_.size());
  const double variance = fit.sigma_m * fit.sigma_m;
  const double gate = gate_m(variance);
  for (const Eigen::Vector2d& q : stems_m_) {
    const auto partner = index_.grid().nearest(fit.placement * q, gate);
    if (partner.stem >= 0) pairs.push_back({partner.stem, partner.squared_m2});
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.map, a.squared_m2) < std::tie(b.map, b.squared_m2);
  });
  double nats = 0.0;
  fit.inliers = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (k > 0 && pairs[k].map == pairs[k - 1].map) continue;
    nats += std::log(kFalseShare + (1.0 - kFalseShare) * gain(pairs[k].squared_m2, variance,
                                                              density_at(pairs[k].map)));
    ++fit.inliers;
  }
  nats +=
      static_cast<double>(static_cast<int>(stems_m_.size()) - fit.inliers) * std::log(kFalseShare);
  fit.evidence_nats = nats - price_nats(fit);
}

}  // namespace honka
