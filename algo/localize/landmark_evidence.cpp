#include "algo/localize/landmark_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace honka {
namespace {

/// How visible a stem is beside others at its range, and how many are so: undergrowth and forked
/// neighbours hide some from every side. Choice: a hidden stem must outlast a few misses that take
/// another out, and what was felled must not outlast many.
constexpr std::array<double, 2> kVisibility = {1.0, 0.5};
constexpr std::array<double, 2> kVisibilityShare = {0.9, 0.1};

}  // namespace

LandmarkEvidence::LandmarkEvidence(const RangeRates& rates, double false_rate)
    : never_{std::log(1.0 - false_rate), std::log(false_rate)} {
  for (std::size_t bin = 0; bin < rates.size(); ++bin) {
    for (std::size_t u = 0; u < kVisibilities; ++u) {
      const double rate = kVisibility[u] * rates[bin];
      stands_[bin][0][u] = std::log(1.0 - rate);
      stands_[bin][1][u] = std::log(rate);
    }
  }
}

double LandmarkEvidence::log_sum(const ByVisibility& logs) {
  ByVisibility shared = logs;
  for (std::size_t u = 0; u < kVisibilities; ++u) shared[u] += std::log(kVisibilityShare[u]);
  const double greatest = *std::max_element(shared.begin(), shared.end());
  double sum = 0.0;
  for (const double value : shared) sum += std::exp(value - greatest);
  return greatest + std::log(sum);
}

double LandmarkEvidence::stands_over_never(const MapLandmark& landmark) const {
  ByVisibility stands{};
  double never = 0.0;
  for (const LandmarkView& view : landmark.views) {
    never += log_never(view);
    for (std::size_t u = 0; u < kVisibilities; ++u) stands[u] += log_stands(view)[u];
  }
  return log_sum(stands) - never;
}

double LandmarkEvidence::gone_over_stands(const MapLandmark& landmark) const {
  if (landmark.views.empty()) return 0.0;
  double gone_since = 0.0;
  for (const LandmarkView& view : landmark.views) gone_since += log_never(view);
  ByVisibility stood{};
  double gone = -std::numeric_limits<double>::infinity();
  for (const LandmarkView& view : landmark.views) {
    gone = std::max(gone, log_sum(stood) + gone_since);
    gone_since -= log_never(view);
    for (std::size_t u = 0; u < kVisibilities; ++u) stood[u] += log_stands(view)[u];
  }
  return gone - log_sum(stood);
}

RangeRates detection_rates(const std::vector<MapLandmark>& landmarks, double false_rate) {
  constexpr int kSteps = 10;
  RangeRates rates;
  rates.fill(0.5);
  double standing_share = 0.5;
  for (int step = 0; step < kSteps; ++step) {
    const LandmarkEvidence evidence(rates, false_rate);
    RangeRates expected, seen;
    expected.fill(2.0);  // a rate of one half where nothing is known
    seen.fill(1.0);
    double standing = 1.0, all = 2.0;
    for (const MapLandmark& landmark : landmarks) {
      if (!landmark.in_map || landmark.views.empty()) continue;
      const double odds = standing_share / (1.0 - standing_share) *
                          std::exp(std::min(evidence.stands_over_never(landmark), 100.0));
      const double stands = odds / (1.0 + odds);
      for (const LandmarkView& view : landmark.views) {
        expected[view.bin] += stands;
        seen[view.bin] += view.seen ? stands : 0.0;
      }
      standing += stands;
      all += 1.0;
    }
    for (std::size_t bin = 0; bin < rates.size(); ++bin) {
      rates[bin] = std::clamp(seen[bin] / expected[bin], 2.0 * false_rate, 0.95);
    }
    standing_share = standing / all;
  }
  return rates;
}

}  // namespace honka
