#include "eval/run/slam/link_quality.h"

#include <optional>
#include <set>

#include "algo/geometry/kdtree.h"
#include "algo/slam/chain.h"
#include "algo/slam/map_quality/blur.h"
#include "algo/slam/map_quality/clusters.h"
#include "eval/metrics/statistics.h"
#include "eval/metrics/trajectory_alignment.h"

namespace honka::eval {
namespace {

constexpr double kClusterLink_m = 0.5;

PosePairs pairs_of(const SlamDrive& drive, std::span<const SparseFrame> frames,
                   const FramePoses& T_first_frame) {
  PosePairs pairs;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto number = static_cast<std::size_t>(frames[i].number);
    pairs.poses.push_back(
        {drive.times_s[number], drive.true_T_first_frame[number], T_first_frame[i]});
  }
  return pairs;
}

/// Rigid; by yaw alone where the way is straight; nothing where the machine never moved.
std::optional<Similarity3> laid_onto_truth(const PosePairs& pairs) {
  for (const Alignment alignment : {Alignment::kSe3, Alignment::kYaw}) {
    const AlignmentResult result = align(pairs, alignment);
    if (result.status == AlignmentStatus::kAligned) return result.T_truth_estimate;
  }
  return std::nullopt;
}

void judge_path(const PosePairs& aligned, LinkMapQuality& quality) {
  std::vector<double> errors_m, planar_m;
  for (const PosePair& pair : aligned.poses) {
    const Eigen::Vector3d error_m = pair.estimate.translation() - pair.truth.translation();
    errors_m.push_back(error_m.norm());
    planar_m.push_back(error_m.head<2>().norm());
  }
  if (const auto error_m = rmse(errors_m)) quality.ate_m = *error_m;
  if (const auto error_m = rmse(planar_m)) quality.ate_planar_m = *error_m;
}

void judge_stems(const SlamDrive& drive, std::span<const MapStem> stems,
                 const Similarity3& T_truth_map, LinkMapQuality& quality) {
  std::vector<Eigen::Vector2d> truth;
  for (const Eigen::Vector3d& stem : drive.true_stems_in_first_m) truth.push_back(stem.head<2>());
  const KdTree2 tree(truth);
  std::set<std::uint32_t> mapped;
  std::vector<double> errors_m;
  for (const MapStem& stem : stems) {
    const Eigen::Vector3d place = T_truth_map * stem.position_in_first_m;
    const auto nearest = tree.nearest(Eigen::Vector2d(place.head<2>()));
    if (!nearest || nearest->distance_m > kMappedStemGate_m) {
      ++quality.stems_false;
      continue;
    }
    mapped.insert(nearest->index);
    errors_m.push_back(nearest->distance_m);
  }
  quality.stems_mapped = static_cast<std::int64_t>(mapped.size());
  if (const auto error_m = rmse(errors_m)) quality.stem_rmse_m = *error_m;
}

}  // namespace

LinkMapQuality judge_link_map(const SlamDrive& drive, std::span<const SparseFrame> frames,
                              const FramePoses& T_first_frame, std::span<const MapStem> stems) {
  LinkMapQuality quality;
  const auto map_m = map_points(frames, T_first_frame);
  if (!map_m.empty()) quality.blur = blur(map_m, {});
  ClusterSettings clusters;
  clusters.link_m = kClusterLink_m;
  const RegistrationNoise noise = registration_noise(map_m, clusters);
  if (noise.clusters > 0) quality.cluster_rmse_m = noise.mean_rmse_m;
  const PosePairs pairs = pairs_of(drive, frames, T_first_frame);
  const auto T_truth_map = laid_onto_truth(pairs);
  if (!T_truth_map) return quality;
  judge_path(moved(pairs, *T_truth_map), quality);
  judge_stems(drive, stems, *T_truth_map, quality);
  return quality;
}

}  // namespace honka::eval
