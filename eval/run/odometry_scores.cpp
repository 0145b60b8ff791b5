#include "eval/run/odometry_scores.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "eval/metrics/trajectory_alignment.h"

namespace honka::eval {
namespace {

bool is_unregistered(const OdometryEstimate& estimate) {
  return estimate.status == OdometryStatus::kPredicted ||
         estimate.status == OdometryStatus::kRefused;
}

/// Marks runs of unregistered sweeps that last longer than the limit.
void mark_unregistered(const OdometryRun& run, double longest_s, std::vector<bool>& lost) {
  const std::size_t n = run.estimates.size();
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end < n && is_unregistered(run.estimates[end])) ++end;
    if (static_cast<double>(end - i) * run.period_s > longest_s) {
      std::fill(lost.begin() + static_cast<std::ptrdiff_t>(i),
                lost.begin() + static_cast<std::ptrdiff_t>(end), true);
    }
    i = std::max(end, i + 1);
  }
}

/// Marks the sweeps of motions over `span_s` that are wrong by more than a limit.
void mark_wrong_motions(const OdometryRun& run, const LostLimits& limits, std::vector<bool>& lost) {
  const auto span = static_cast<std::size_t>(std::lround(limits.span_s / run.period_s));
  std::vector<Motion> motions;
  for (std::size_t i = 0; i + span < run.pairs.poses.size(); ++i) motions.push_back({i, i + span});
  const TrajectoryErrors errors = relative_errors(run.pairs, motions);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    if (errors.translation_m[i] <= limits.translation_m &&
        errors.rotation_deg[i] <= limits.rotation_deg) {
      continue;
    }
    std::fill_n(lost.begin() + static_cast<std::ptrdiff_t>(i), span + 1, true);
  }
}

std::string main_cause(const OdometryRun& run, std::size_t begin, std::size_t end) {
  std::map<std::string, std::int64_t> counts;
  for (std::size_t i = begin; i < end; ++i) {
    const OdometryCause cause = run.estimates[i].cause;
    if (cause != OdometryCause::kNone) ++counts[std::string(name_of(cause))];
  }
  if (counts.empty()) return "unnoticed";
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

void append_all(TrajectoryErrors& errors, const TrajectoryErrors& more) {
  errors.translation_m.insert(errors.translation_m.end(), more.translation_m.begin(),
                              more.translation_m.end());
  errors.rotation_deg.insert(errors.rotation_deg.end(), more.rotation_deg.begin(),
                             more.rotation_deg.end());
}

}  // namespace

std::vector<LostSequence> lost_sequences(const OdometryRun& run, const LostLimits& limits) {
  const std::size_t n = run.estimates.size();
  std::vector<bool> lost(n, false);
  mark_unregistered(run, limits.predicted_s, lost);
  mark_wrong_motions(run, limits, lost);
  std::vector<LostSequence> sequences;
  for (std::size_t i = 0; i < n; ++i) {
    if (!lost[i]) continue;
    std::size_t end = i;
    while (end < n && lost[end]) ++end;
    sequences.push_back({run.pairs.poses[i].time_s, run.pairs.poses[end - 1].time_s + run.period_s,
                         main_cause(run, i, end)});
    i = end;
  }
  return sequences;
}

PosePairs aligned_by_yaw(const PosePairs& pairs) {
  AlignmentResult result = align(pairs, Alignment::kYaw);
  if (result.status != AlignmentStatus::kAligned) result = align(pairs, Alignment::kOrigin);
  return moved(pairs, result.T_truth_estimate);
}

void OdometryScores::merge(const OdometryScores& other) {
  trials += other.trials;
  driven_m += other.driven_m;
  sensor_s += other.sensor_s;
  cpu_s += other.cpu_s;
  sub_paths.insert(sub_paths.end(), other.sub_paths.begin(), other.sub_paths.end());
  append_all(rpe_per_metre, other.rpe_per_metre);
  append_all(ape, other.ape);
  for (std::size_t i = 0; i < statuses.size(); ++i) statuses[i] += other.statuses[i];
  for (const auto& [cause, sweeps] : other.causes) causes[cause] += sweeps;
  lost.insert(lost.end(), other.lost.begin(), other.lost.end());
  times_ms.insert(times_ms.end(), other.times_ms.begin(), other.times_ms.end());
}

OdometryScores score_odometry(const OdometryRun& run) {
  OdometryScores scores;
  scores.stand = run.stand;
  scores.odometry = run.odometry;
  scores.trials = 1;
  scores.driven_m = run.driven_m.empty() ? 0.0 : run.driven_m.back() - run.driven_m.front();
  scores.sensor_s = run.period_s * static_cast<double>(run.estimates.size());
  scores.cpu_s = 1e-3 * std::accumulate(run.times_ms.begin(), run.times_ms.end(), 0.0);
  scores.times_ms = run.times_ms;
  scores.sub_paths = sub_path_errors(run.pairs, run.driven_m);
  const RelativeSettings per_metre{1.0, DeltaUnit::kMetres};
  scores.rpe_per_metre = relative_errors(run.pairs, motions(run.pairs, per_metre));
  scores.ape = absolute_errors(aligned_by_yaw(run.pairs));
  for (const OdometryEstimate& estimate : run.estimates) {
    ++scores.statuses.at(static_cast<std::size_t>(estimate.status));
    if (estimate.cause != OdometryCause::kNone) {
      ++scores.causes[std::string(name_of(estimate.cause))];
    }
  }
  scores.lost = lost_sequences(run);
  return scores;
}

}  // namespace honka::eval
