#include "algo/slam/map_quality/frame_elimination.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/slam/chain.h"
#include "algo/types/check.h"

namespace honka {

FrameShares frame_shares(std::span<const SparseFrame> frames, const FramePoses& T_first_frame,
                         const ClusterSettings& settings) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  const std::vector<Eigen::Vector3d> map_m = map_points(frames, T_first_frame);
  std::vector<std::uint32_t> frame_of;
  frame_of.reserve(map_m.size());
  for (std::uint32_t l = 0; l < frames.size(); ++l) {
    frame_of.insert(frame_of.end(), frames[l].points_m.size(), l);
  }
  FrameShares shares;
  shares.w_m2.assign(frames.size(), 0.0);
  shares.points.assign(frames.size(), 0);
  const std::vector<TreeCluster> clusters = tree_clusters(map_m, settings);
  const RegistrationNoise noise = registration_noise(clusters);
  // Nevalainen2021 Eq. (33)
  for (const TreeCluster& cluster : clusters) {
    for (const std::uint32_t p : cluster.points) {
      shares.w_m2[frame_of[p]] +=
          (map_m[p] - cluster.centre_m).head<2>().squaredNorm() / static_cast<double>(noise.points);
      ++shares.points[frame_of[p]];
    }
  }
  shares.e_c_m = noise.pooled_rmse_m;
  return shares;
}

std::vector<std::size_t> worst_frames(const FrameShares& shares, std::size_t count) {
  if (shares.w_m2.size() < 2) return {};
  std::vector<std::size_t> positions(shares.w_m2.size() - 1);
  std::iota(positions.begin(), positions.end(), std::size_t{1});
  std::stable_sort(positions.begin(), positions.end(),
                   [&](std::size_t a, std::size_t b) { return shares.w_m2[a] > shares.w_m2[b]; });
  positions.resize(std::min(count, positions.size()));
  std::sort(positions.begin(), positions.end());
  return positions;
}

void remove_frames(std::vector<SparseFrame>& frames, FramePoses& T_first_frame,
                   std::span<const std::size_t> positions) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  std::size_t kept = 0, next = 0;
  for (std::size_t l = 0; l < frames.size(); ++l) {
    if (next < positions.size() && positions[next] == l) {
      ++next;
      continue;
    }
    if (kept != l) {
      frames[kept] = std::move(frames[l]);
      T_first_frame[kept] = T_first_frame[l];
    }
    ++kept;
  }
  frames.resize(kept);
  T_first_frame.resize(kept);
}

}  // namespace honka
