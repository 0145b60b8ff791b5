#include "eval/metrics/trajectory_errors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"
#include "algo/types/check.h"
#include "eval/metrics/statistics.h"

namespace honka::eval {
namespace {

/// Path lengths this near to delta have reached it, so that rounding does not choose the pairs.
constexpr double kPathRounding = 1e-9;
/// Of delta: how far the path of one of all pairs may be from it (evo's default).
constexpr double kPathTolerance = 0.1;

void add(TrajectoryErrors& errors, const Pose3& error) {
  errors.translation_m.push_back(error.translation().norm());
  errors.rotation_deg.push_back(rad_to_deg(Eigen::AngleAxisd(error.linear()).angle()));
}

/// Path length of the estimate up to each pose.
std::vector<double> path_m(const std::vector<PosePair>& poses) {
  std::vector<double> path(poses.size(), 0.0);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    path[i] = path[i - 1] +
              (poses[i].estimate.translation() - poses[i - 1].estimate.translation()).norm();
  }
  return path;
}

std::vector<Motion> motions_over_time(const PosePairs& pairs, double delta_s) {
  std::vector<double> paired_s;
  for (const PosePair& pair : pairs.poses) paired_s.push_back(pair.time_s);
  const std::vector<double>& all_s =
      pairs.estimate_times_s.empty() ? paired_s : pairs.estimate_times_s;
  std::vector<Motion> result;
  for (std::size_t i = 0; i < paired_s.size(); ++i) {
    const double end_s = all_s[nearest_time(all_s, paired_s[i] + delta_s)];
    if (end_s <= paired_s[i] || end_s >= all_s.back()) continue;
    const std::size_t j = nearest_time(paired_s, end_s);
    if (paired_s[j] == end_s) result.push_back({i, j});
  }
  return result;
}

std::vector<Motion> consecutive_motions_over_path(const std::vector<double>& path, double delta_m) {
  std::vector<Motion> result;
  std::optional<std::size_t> last_end;
  double since_m = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i] - since_m < delta_m * (1.0 - kPathRounding)) continue;
    if (last_end) result.push_back({*last_end, i});
    last_end = i;
    since_m = path[i];
  }
  return result;
}

std::vector<Motion> all_motions_over_path(const std::vector<double>& path, double delta_m) {
  std::vector<Motion> result;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto begin = path.begin() + static_cast<std::ptrdiff_t>(i) + 1;
    // The first of equal path lengths, and the nearer neighbour of the wanted one.
    const auto after = std::lower_bound(begin, path.end(), path[i] + delta_m);
    auto best = after;
    if (after == path.end() ||
        (after != begin && path[i] + delta_m - *(after - 1) <= *after - (path[i] + delta_m))) {
      best = std::lower_bound(begin, path.end(), *(after - 1));
    }
    if (std::abs(*best - path[i] - delta_m) > kPathTolerance * delta_m) continue;
    result.push_back({i, static_cast<std::size_t>(best - path.begin())});
  }
  return result;
}

std::vector<Motion> motions_over_frames(std::size_t poses, std::size_t delta, bool all_pairs) {
  std::vector<Motion> result;
  if (delta >= poses) return result;
  for (std::size_t i = 0; i < poses - delta; i += all_pairs ? 1 : delta) {
    result.push_back({i, i + delta});
  }
  return result;
}

}  // namespace

std::optional<TrajectoryStatistics> trajectory_statistics(std::span<const double> errors) {
  if (errors.empty()) return std::nullopt;
  TrajectoryStatistics s;
  const auto n = static_cast<double>(errors.size());
  s.mean = *mean(errors);
  double scatter = 0.0;
  for (const double error : errors) {
    s.sse += error * error;
    scatter += (error - s.mean) * (error - s.mean);
  }
  s.rmse = std::sqrt(s.sse / n);
  s.std = std::sqrt(scatter / n);
  s.median = *median(errors);
  s.min = *minimum(errors);
  s.max = *maximum(errors);
  return s;
}

TrajectoryErrors absolute_errors(const PosePairs& pairs) {
  TrajectoryErrors errors;
  for (const PosePair& pair : pairs.poses) {
    if (pairs.have_rotations()) {
      add(errors, pair.truth.inverse() * pair.estimate);
    } else {
      errors.translation_m.push_back(
          (pair.estimate.translation() - pair.truth.translation()).norm());
    }
  }
  return errors;
}

std::vector<Motion> motions(const PosePairs& pairs, const RelativeSettings& settings) {
  HONKA_CHECK(settings.delta > 0.0, "a motion goes somewhere");
  switch (settings.unit) {
    case DeltaUnit::kSeconds:
      return motions_over_time(pairs, settings.delta);
    case DeltaUnit::kMetres:
      return settings.all_pairs
                 ? all_motions_over_path(path_m(pairs.poses), settings.delta)
                 : consecutive_motions_over_path(path_m(pairs.poses), settings.delta);
    case DeltaUnit::kFrames:
      return motions_over_frames(pairs.poses.size(), static_cast<std::size_t>(settings.delta),
                                 settings.all_pairs);
  }
  return {};
}

TrajectoryErrors relative_errors(const PosePairs& pairs, std::span<const Motion> motions) {
  TrajectoryErrors errors;
  for (const Motion& motion : motions) {
    const PosePair& a = pairs.poses.at(motion.from);
    const PosePair& b = pairs.poses.at(motion.to);
    if (pairs.have_rotations()) {
      add(errors, (a.truth.inverse() * b.truth).inverse() * (a.estimate.inverse() * b.estimate));
    } else {
      const double true_m = (b.truth.translation() - a.truth.translation()).norm();
      const double estimated_m = (b.estimate.translation() - a.estimate.translation()).norm();
      errors.translation_m.push_back(std::abs(estimated_m - true_m));
    }
  }
  return errors;
}

}  // namespace honka::eval
