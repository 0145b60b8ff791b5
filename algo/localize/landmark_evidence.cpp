#include "algo/localize/landmark_evidence.h"

#include <algorithm>

namespace honka {
namespace {

/// How visible a stem is beside others at its range, and how many are so: undergrowth and forked
/// neighbours hide some from every side. Choice: few enough that what was felled outlasts a view
/// more at most; what is hidden is seen often enough in the end to stand.
constexpr std::array<double, 2> kVisibility = {1.0, 0.5};
constexpr std::array<double, 2> kVisibilityShare = {0.98, 0.02};

/// Share of the stems that is felled from one counted view to the next. Choice: high, so that a
/// long past does not outweigh the last few views.
constexpr double kFelled = 0.01;
/// And that comes to be seen: trees grow slowly, a mistake is undone. Choice: far below what the
/// decision asks for, or misses of low rates would never come to it.
constexpr double kCome = 1e-4;

constexpr double kGreatestRatio = 1e30;

}  // namespace

LandmarkEvidence::LandmarkEvidence(const RangeRates& rates, double false_rate) {
  for (std::size_t bin = 0; bin < rates.size(); ++bin) {
    const ByState seen = {false_rate, kVisibility[0] * rates[bin], kVisibility[1] * rates[bin]};
    likelihood_[bin] = {ByState{1.0 - seen[0], 1.0 - seen[1], 1.0 - seen[2]}, seen};
  }
}

double LandmarkEvidence::stands_over_never(const MapLandmark& landmark) const {
  double visible = kVisibilityShare[0], hidden = kVisibilityShare[1];
  for (const LandmarkView& view : landmark.views) {
    const ByState& l = likelihood(view);
    visible = std::min(visible * l[1] / l[0], kGreatestRatio);
    hidden = std::min(hidden * l[2] / l[0], kGreatestRatio);
  }
  return std::min(visible + hidden, kGreatestRatio);
}

bool LandmarkEvidence::stands(const MapLandmark& landmark, double decision_ratio) const {
  bool stands = landmark.in_map;
  double gone = 0.5, visible = 0.5 * kVisibilityShare[0], hidden = 0.5 * kVisibilityShare[1];
  for (const LandmarkView& view : landmark.views) {
    const double felled = kFelled * (visible + hidden), come = kCome * gone;
    gone += felled - come;
    visible += kVisibilityShare[0] * come - kFelled * visible;
    hidden += kVisibilityShare[1] * come - kFelled * hidden;
    const ByState& l = likelihood(view);
    gone *= l[0];
    visible *= l[1];
    hidden *= l[2];
    const double all = gone + visible + hidden;
    gone /= all;
    visible /= all;
    hidden /= all;
    if (gone > decision_ratio * (visible + hidden)) stands = false;
    if (visible + hidden > decision_ratio * gone) stands = true;
  }
  return stands;
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
      const double odds =
          standing_share / (1.0 - standing_share) * evidence.stands_over_never(landmark);
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
