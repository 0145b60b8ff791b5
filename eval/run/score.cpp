#include "eval/run/score.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "algo/geometry/se3.h"
#include "algo/types/user_error.h"
#include "eval/io/csv.h"
#include "eval/io/recording.h"
#include "eval/io/tum.h"
#include "eval/metrics/statistics.h"
#include "eval/metrics/stem_scores.h"

namespace honka::eval {
namespace {

using Json = nlohmann::ordered_json;

/// A found stem is true when a tree stands this near.
constexpr double kStemGate_m = 0.5;

struct PosePair {
  Pose3 truth, estimate;
};

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

std::vector<PosePair> associate(const std::vector<TimedPose>& truth,
                                const std::vector<TimedPose>& estimates) {
  std::vector<PosePair> pairs;
  for (const TimedPose& estimate : estimates) {
    const auto after =
        std::lower_bound(truth.begin(), truth.end(), estimate.time_s,
                         [](const TimedPose& pose, double time_s) { return pose.time_s < time_s; });
    if (after == truth.end() || (after == truth.begin() && estimate.time_s < after->time_s)) {
      continue;
    }
    if (after == truth.begin()) {
      pairs.push_back({after->pose, estimate.pose});
      continue;
    }
    const auto before = after - 1;
    const double share = (estimate.time_s - before->time_s) / (after->time_s - before->time_s);
    pairs.push_back({interpolate(before->pose, after->pose, share), estimate.pose});
  }
  return pairs;
}

Json statistics(const std::vector<double>& values) {
  double square_sum = 0.0;
  for (const double v : values) square_sum += v * v;
  const auto number = [](const std::optional<double>& x) { return x ? Json(*x) : Json(nullptr); };
  return {{"rmse", number(rmse(values))},
          {"mean", number(mean(values))},
          {"median", number(median(values))},
          {"std", number(standard_deviation(values))},
          {"min", number(minimum(values))},
          {"max", number(maximum(values))},
          {"sse", square_sum}};
}

Json ape(const std::vector<PosePair>& pairs, const Pose3& T_truth_estimate) {
  std::vector<double> translation_m, rotation_deg;
  for (const PosePair& pair : pairs) {
    const Pose3 error = pair.truth.inverse() * (T_truth_estimate * pair.estimate);
    translation_m.push_back(error.translation().norm());
    rotation_deg.push_back(rad_to_deg(Eigen::AngleAxisd(error.linear()).angle()));
  }
  return {{"translation_m", statistics(translation_m)}, {"rotation_deg", statistics(rotation_deg)}};
}

/// The rigid transform that brings the estimated positions nearest to the true ones (Umeyama 1991).
Pose3 align(const std::vector<PosePair>& pairs) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Eigen::Matrix3Xd truth(3, n), estimate(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    truth.col(i) = pairs[static_cast<std::size_t>(i)].truth.translation();
    estimate.col(i) = pairs[static_cast<std::size_t>(i)].estimate.translation();
  }
  return Pose3(Eigen::umeyama(estimate, truth, false));
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
  const std::vector<PosePair> pairs = associate(truth_of(recording), estimates);
  if (pairs.empty()) {
    throw UserError(poses.string() +
                    ": none of its times lies within the recording; times are "
                    "seconds since the start of the drive");
  }
  Json json;
  json["estimate_poses"] = estimates.size();
  json["associated"] = pairs.size();
  json["ape"] = ape(pairs, Pose3::Identity());
  json["ape_se3"] = pairs.size() < 3 ? Json(nullptr) : ape(pairs, align(pairs));
  if (!stems.empty()) json["stems"] = stem_scores(recording, stems);
  return json.dump(2) + "\n";
}

}  // namespace honka::eval
