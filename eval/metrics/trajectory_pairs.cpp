#include "eval/metrics/trajectory_pairs.h"

#include <algorithm>
#include <cmath>

#include "algo/types/check.h"

namespace honka::eval {
namespace {

/// A time of the shorter list and the one of the longer list nearest to it.
struct Claim {
  std::size_t from = 0, to = 0;
  double difference_s = 0.0;
};

/// Claims in order, one for each time of the longer list. Nearest times never cross, so that
/// rivals stand side by side.
std::vector<Claim> claims(std::span<const double> from_s, std::span<const double> to_s,
                          double max_difference_s) {
  std::vector<Claim> kept;
  for (std::size_t i = 0; i < from_s.size(); ++i) {
    const std::size_t to = nearest_time(to_s, from_s[i]);
    const Claim claim{i, to, std::abs(to_s[to] - from_s[i])};
    if (claim.difference_s > max_difference_s) continue;
    if (kept.empty() || kept.back().to != to) {
      kept.push_back(claim);
    } else if (claim.difference_s < kept.back().difference_s) {
      kept.back() = claim;
    }
  }
  return kept;
}

}  // namespace

std::size_t nearest_time(std::span<const double> times_s, double time_s) {
  HONKA_CHECK(!times_s.empty(), "there is no nearest of no times");
  const auto after = std::lower_bound(times_s.begin(), times_s.end(), time_s);
  const auto index = static_cast<std::size_t>(after - times_s.begin());
  if (index == 0) return 0;
  if (index == times_s.size()) return index - 1;
  return time_s - times_s[index - 1] <= times_s[index] - time_s ? index - 1 : index;
}

std::vector<TimePair> associate_times(std::span<const double> truth_s,
                                      std::span<const double> estimate_s, double max_difference_s) {
  std::vector<TimePair> pairs;
  if (truth_s.empty() || estimate_s.empty()) return pairs;
  if (estimate_s.size() <= truth_s.size()) {
    for (const Claim& c : claims(estimate_s, truth_s, max_difference_s)) {
      pairs.push_back({c.to, c.from});
    }
  } else {
    for (const Claim& c : claims(truth_s, estimate_s, max_difference_s)) {
      pairs.push_back({c.from, c.to});
    }
  }
  return pairs;
}

}  // namespace honka::eval
