#include "eval/run/slam/progress_claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "eval/metrics/statistics.h"
#include "eval/report/report_model.h"

namespace honka::eval {
namespace {

constexpr double kSameMinimum = 0.05;   ///< e_C at the least β is within this share of its least
constexpr double kStable = 0.10;        ///< share of its start by which the step error may move
constexpr double kDimensionGap = 0.15;  ///< by which d may miss a figure of the paper
constexpr double kDivergence = 0.10;    ///< share of its least by which β has risen in the end
constexpr double kClaimNothing = std::numeric_limits<double>::quiet_NaN();

/// The points at which e_C was measured.
std::vector<const ProgressPoint*> with_noise(const ProgressTrack& track) {
  std::vector<const ProgressPoint*> points;
  for (const ProgressPoint& point : track.points) {
    if (std::isfinite(point.map.cluster_rmse_m) && std::isfinite(point.map.blur)) {
      points.push_back(&point);
    }
  }
  return points;
}

/// Ranks from 0, ties at their mean.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t k = 0; k < order.size();) {
    std::size_t end = k;
    while (end < order.size() && values[order[end]] == values[order[k]]) ++end;
    for (std::size_t m = k; m < end; ++m) {
      result[order[m]] = 0.5 * static_cast<double>(k + end - 1);
    }
    k = end;
  }
  return result;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = mean(a).value_or(0.0), mean_b = mean(b).value_or(0.0);
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ab += (a[k] - mean_a) * (b[k] - mean_b);
    aa += (a[k] - mean_a) * (a[k] - mean_a);
    bb += (b[k] - mean_b) * (b[k] - mean_b);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : kClaimNothing;
}

/// What one track says of a claim: whether it held, and the figures that tell.
struct Verdict {
  bool judged = false, held = false;
  std::vector<double> figures;
};

Verdict minima_together(const ProgressTrack& track) {
  const auto points = with_noise(track);
  if (points.size() < 3) return {};
  const auto least = [&](auto figure) {
    return *std::min_element(points.begin(), points.end(),
                             [&](auto* a, auto* b) { return figure(*a) < figure(*b); });
  };
  const ProgressPoint* sharpest = least([](const ProgressPoint& p) { return p.map.blur; });
  const ProgressPoint* calmest = least([](const ProgressPoint& p) { return p.map.cluster_rmse_m; });
  const double excess = sharpest->map.cluster_rmse_m / calmest->map.cluster_rmse_m - 1.0;
  return {true,
          excess <= kSameMinimum,
          {static_cast<double>(sharpest->applied), static_cast<double>(calmest->applied),
           100.0 * excess, rank_correlation(track)}};
}

Verdict step_error_stable(const ProgressTrack& track) {
  const double start = track.points.front().map.step_error_m;
  double low = start, high = start;
  for (const ProgressPoint& point : track.points) {
    low = std::min(low, point.map.step_error_m);
    high = std::max(high, point.map.step_error_m);
  }
  if (!(start > 0.0)) return {};
  const double moved = std::max(high - start, start - low) / start;
  return {true, moved <= kStable, {start, track.points.back().map.step_error_m, low, high}};
}

Verdict dimension_falls(const ProgressTrack& track) {
  const double start = track.points.front().map.dimension;
  const double end = track.points.back().map.dimension;
  if (!std::isfinite(start) || !std::isfinite(end)) return {};
  double low = start;
  for (const ProgressPoint& point : track.points) low = std::min(low, point.map.dimension);
  const bool held = std::abs(start - 1.4) <= kDimensionGap && std::abs(end - 0.3) <= kDimensionGap;
  return {true, held, {start, low, end, track.floor.dimension}};
}

Verdict loop_diverges(const ProgressTrack& track) {
  const double start = track.points.front().map.blur, end = track.points.back().map.blur;
  double low = start;
  for (const ProgressPoint& point : track.points) low = std::min(low, point.map.blur);
  if (!(low > 0.0) || !std::isfinite(end)) return {};
  return {true, end > (1.0 + kDivergence) * low, {start, low, end}};
}

using Judge = Verdict (*)(const ProgressTrack&);

struct ClaimText {
  const char *claim, *paper, *ours, *criterion;
  int decimals[4];
  Judge judge;
};

const ClaimText kClaims[] = {
    {"β and e_C have their minima together",
     "minima at the same time",
     "least β after {} corrections, least e_C after {}; e_C is {} % above its least where β is "
     "least; rank correlation {}",
     "e_C at the least β within 5 % of its least",
     {0, 0, 1, 2},
     minima_together},
    {"the mean step error is stable",
     "rather stable",
     "{} m at the start, {} m at the end, between {} and {} m",
     "within 10 % of its start",
     {3, 3, 3, 3},
     step_error_stable},
    {"d goes 1.4 → 1 → 0.3",
     "1.4 → 1 → 0.3",
     "{} at the start, least {}, {} at the end; floor {}",
     "start and end within 0.15 of the paper's",
     {2, 2, 2, 2},
     dimension_falls},
    {"without an end condition the loop diverges",
     "needs an end condition",
     "β {} at the start, least {}, {} at the end",
     "β ends more than 10 % above its least",
     {3, 3, 3, 0},
     loop_diverges},
};

ProgressClaim judge_claim(const ClaimText& text, const std::string& side,
                          const std::vector<ProgressTrack>& tracks) {
  ProgressClaim claim;
  claim.claim = text.claim;
  claim.paper = text.paper;
  claim.criterion = text.criterion;
  claim.side = side;
  std::vector<std::vector<double>> figures(4);
  for (const ProgressTrack& track : tracks) {
    if (track.side != side) continue;
    const Verdict verdict = text.judge(track);
    if (!verdict.judged) continue;
    ++claim.trials;
    claim.held_in += verdict.held ? 1 : 0;
    for (std::size_t k = 0; k < verdict.figures.size(); ++k) {
      figures[k].push_back(verdict.figures[k]);
    }
  }
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < 4; ++k) {
    texts.push_back(fixed(mean(figures[k]).value_or(kClaimNothing), text.decimals[k]));
  }
  claim.ours = fmt::format(fmt::runtime(text.ours), texts[0], texts[1], texts[2], texts[3]);
  return claim;
}

}  // namespace

double rank_correlation(const ProgressTrack& track) {
  std::vector<double> blurs, noises;
  for (const ProgressPoint* point : with_noise(track)) {
    blurs.push_back(point->map.blur);
    noises.push_back(point->map.cluster_rmse_m);
  }
  return blurs.size() < 3 ? kClaimNothing : correlation(ranks(blurs), ranks(noises));
}

std::vector<ProgressClaim> judge_claims(const std::vector<ProgressTrack>& tracks) {
  std::vector<std::string> sides;
  for (const ProgressTrack& track : tracks) {
    if (std::find(sides.begin(), sides.end(), track.side) == sides.end()) {
      sides.push_back(track.side);
    }
  }
  std::vector<ProgressClaim> claims;
  for (const ClaimText& text : kClaims) {
    for (const std::string& side : sides) claims.push_back(judge_claim(text, side, tracks));
  }
  return claims;
}

}  // namespace honka::eval
