#include "eval/run/score.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "algo/geometry/se3.h"
#include "algo/types/user_error.h"
#include "eval/io/csv.h"
#include "eval/io/recording.h"
#include "eval/io/tum.h"
#include "eval/metrics/stem_scores.h"
#include "eval/metrics/trajectory_alignment.h"
#include "eval/run/trajectory_json.h"

namespace honka::eval {
namespace {

using Json = nlohmann::ordered_json;

/// A found stem is true when a tree stands this near.
constexpr double kStemGate_m = 0.5;

std::vector<TimedPose> truth_of(const RecordingReader& recording) {
  std::vector<TimedPose> truth;
  for (std::size_t i = 0; i < recording.sweeps(); ++i) {
    const SweepKnots knots = recording.poses(i);
    for (std::size_t k = 0; k < knots.times_s.size(); ++k) {
      // The last knot of a sweep is the first of the next.
      if (!truth.empty() && knots.times_s[k] <= truth.back().time_s) continue;
      truth.push_back({knots.times_s[k], knots.T_world_lidar[k]});
    }
  }
  return truth;
}

PosePairs associate(const std::vector<TimedPose>& truth, const std::vector<TimedPose>& estimates) {
  PosePairs pairs;
  for (const TimedPose& estimate : estimates) {
    const auto after =
        std::lower_bound(truth.begin(), truth.end(), estimate.time_s,
                         [](const TimedPose& pose, double time_s) { return pose.time_s < time_s; });
    if (after == truth.end() || (after == truth.begin() && estimate.time_s < after->time_s)) {
      continue;
    }
    if (after == truth.begin()) {
      pairs.poses.push_back({estimate.time_s, after->pose, estimate.pose});
      continue;
    }
    const auto before = after - 1;
    const double share = (estimate.time_s - before->time_s) / (after->time_s - before->time_s);
    pairs.poses.push_back(
        {estimate.time_s, interpolate(before->pose, after->pose, share), estimate.pose});
  }
  return pairs;
}

/// After rigid alignment; null where the positions do not define one.
Json aligned_ape(const PosePairs& pairs) {
  const AlignmentResult alignment = align(pairs, Alignment::kSe3);
  if (alignment.status != AlignmentStatus::kAligned) return nullptr;
  return errors_json(absolute_errors(moved(pairs, alignment.T_truth_estimate)));
}

Json stem_scores(const RecordingReader& recording, const std::filesystem::path& file) {
  const auto as_set = [](const StemMap& stems) {
    StemSet set;
    for (const Stem& stem : stems) {
      set.positions_m.push_back(stem.position_m);
      set.dbh_m.push_back(stem.dbh_m);
    }
    return set;
  };
  const StemScores scores =
      score_stems(as_set(read_stem_csv(file)), as_set(recording.stems().stems_in_world),
                  Eigen::Vector2d::Zero(), kStemGate_m);
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  return {{"found", scores.all.found},
          {"trees", scores.all.truth},
          {"gate_m", kStemGate_m},
          {"precision", number(scores.all.precision())},
          {"recall", number(scores.all.recall())},
          {"f1", number(scores.all.f1())},
          {"position_rmse_m", number(scores.position_rmse_m)},
          {"dbh_rmse_m", number(scores.dbh_rmse_m)}};
}

}  // namespace

std::string score(const std::filesystem::path& recording_file, const std::filesystem::path& poses,
                  const std::filesystem::path& stems) {
  const RecordingReader recording(recording_file);
  const std::vector<TimedPose> estimates = read_tum(poses);
  const PosePairs pairs = associate(truth_of(recording), estimates);
  if (pairs.poses.empty()) {
    throw UserError(poses.string() +
                    ": none of its times lies within the recording; times are "
                    "seconds since the start of the drive");
  }
  Json json;
  json["estimate_poses"] = estimates.size();
  json["associated"] = pairs.poses.size();
  json["ape"] = errors_json(absolute_errors(pairs));
  json["ape_se3"] = aligned_ape(pairs);
  if (!stems.empty()) json["stems"] = stem_scores(recording, stems);
  return json.dump(2) + "\n";
}

}  // namespace honka::eval
