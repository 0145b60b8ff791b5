#include "eval/metrics/trajectory_drift.h"

#include <algorithm>

#include "algo/types/check.h"
#include "eval/metrics/trajectory_errors.h"

namespace honka::eval {
namespace {

/// Ways this near to a length have reached it, so that rounding does not choose the poses.
constexpr double kWayRounding_m = 1e-9;

/// Index of the first pose that has driven `way_m`; the number of poses where none has.
std::size_t first_at(std::span<const double> driven_m, double way_m) {
  const auto reached = std::lower_bound(driven_m.begin(), driven_m.end(), way_m - kWayRounding_m);
  return static_cast<std::size_t>(reached - driven_m.begin());
}

std::vector<Motion> sub_paths(std::span<const double> driven_m, double length_m, double step_m) {
  std::vector<Motion> result;
  for (std::int64_t k = 0; !driven_m.empty(); ++k) {
    const std::size_t from = first_at(driven_m, driven_m.front() + step_m * static_cast<double>(k));
    if (from == driven_m.size()) break;
    const std::size_t to = first_at(driven_m, driven_m[from] + length_m);
    if (to == driven_m.size()) break;
    if (result.empty() || result.back().from != from) result.push_back({from, to});
  }
  return result;
}

}  // namespace

std::vector<SubPathError> sub_path_errors(const PosePairs& pairs, std::span<const double> driven_m,
                                          const DriftSettings& settings) {
  HONKA_CHECK(driven_m.size() == pairs.poses.size(), "one way driven for each pair");
  HONKA_CHECK(settings.step_m > 0.0 && pairs.have_rotations(), "a step, and poses with rotations");
  std::vector<SubPathError> result;
  for (const double length_m : settings.lengths_m) {
    const std::vector<Motion> motions = sub_paths(driven_m, length_m, settings.step_m);
    const TrajectoryErrors errors = relative_errors(pairs, motions);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      result.push_back({length_m, pairs.poses[motions[i].from].time_s, errors.translation_m[i],
                        errors.rotation_deg[i]});
    }
  }
  return result;
}

std::optional<Drift> mean_drift(std::span<const SubPathError> errors,
                                std::optional<double> length_m) {
  Drift drift;
  for (const SubPathError& error : errors) {
    if (length_m && error.length_m != *length_m) continue;
    drift.percent += 100.0 * error.translation_m / error.length_m;
    drift.deg_per_m += error.rotation_deg / error.length_m;
    ++drift.sub_paths;
  }
  if (drift.sub_paths == 0) return {};
  drift.percent /= static_cast<double>(drift.sub_paths);
  drift.deg_per_m /= static_cast<double>(drift.sub_paths);
  return drift;
}

}  // namespace honka::eval
