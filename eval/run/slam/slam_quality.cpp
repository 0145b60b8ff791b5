#include "eval/run/slam/slam_quality.h"

#include "algo/slam/chain.h"
#include "algo/slam/map_quality/box_counting.h"
#include "algo/types/check.h"
#include "eval/metrics/statistics.h"
#include "eval/metrics/trajectory_alignment.h"
#include "eval/metrics/trajectory_errors.h"

namespace honka::eval {
namespace {

constexpr double kUnknownQuality = std::numeric_limits<double>::quiet_NaN();

/// Noise of the clusters at a link; NaN where no cluster is.
RegistrationNoise noise_or_nan(std::span<const Eigen::Vector3d> map, double link_m) {
  ClusterSettings settings;
  settings.link_m = link_m;
  RegistrationNoise noise = registration_noise(map, settings);
  if (noise.clusters == 0) noise.mean_rmse_m = noise.pooled_rmse_m = kUnknownQuality;
  return noise;
}

}  // namespace

PosePairs laid_on_truth(const SlamDrive& drive, const FramePoses& T_first_frame) {
  HONKA_CHECK(T_first_frame.size() == drive.frames.size(), "as many poses as frames");
  PosePairs pairs;
  for (std::size_t i = 0; i < T_first_frame.size(); ++i) {
    pairs.poses.push_back({drive.times_s[i], drive.true_T_first_frame[i], T_first_frame[i]});
  }
  for (const Alignment alignment : {Alignment::kSe3, Alignment::kYaw}) {
    const AlignmentResult fitted = align(pairs, alignment);
    if (fitted.status == AlignmentStatus::kAligned) return moved(pairs, fitted.T_truth_estimate);
  }
  return pairs;
}

SlamQuality judge_slam(const SlamDrive& drive, const FramePoses& T_first_frame,
                       const BlurSettings& blur_settings) {
  SlamQuality quality;
  const std::vector<Eigen::Vector3d> map = map_points(drive.frames, T_first_frame);
  if (!map.empty()) {
    quality.blur = blur(map, blur_settings);
    quality.box_dimension = box_dimension(map, {});
    const RegistrationNoise wide = noise_or_nan(map, 1.0), narrow = noise_or_nan(map, 0.5);
    quality.cluster_rmse_m = wide.mean_rmse_m;
    quality.pooled_rmse_m = wide.pooled_rmse_m;
    quality.cluster_rmse_05_m = narrow.mean_rmse_m;
    quality.pooled_rmse_05_m = narrow.pooled_rmse_m;
  }
  const PosePairs pairs = laid_on_truth(drive, T_first_frame);
  const TrajectoryErrors errors = absolute_errors(pairs);
  std::vector<double> planar_m;
  for (const PosePair& pair : pairs.poses) {
    planar_m.push_back((pair.estimate.translation() - pair.truth.translation()).head<2>().norm());
  }
  quality.ate_m = rmse(errors.translation_m).value_or(kUnknownQuality);
  quality.ate_planar_m = rmse(planar_m).value_or(kUnknownQuality);
  quality.ate_deg = rmse(errors.rotation_deg).value_or(kUnknownQuality);
  return quality;
}

}  // namespace honka::eval
