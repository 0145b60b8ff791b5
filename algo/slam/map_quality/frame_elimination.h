#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algo/slam/map_quality/clusters.h"
#include "algo/slam/sparse_frame.h"

namespace honka {

/// What each frame adds to the map's error.
struct FrameShares {
  std::vector<double> w_m2;          ///< of each frame; their sum is e_C², pooled
  std::vector<std::int64_t> points;  ///< clustered points of each frame
  double e_c_m = 0.0;                ///< pooled RMSE of the clustered points
};

/// e_C² rearranged into a sum over frames; a point counts only where it belongs to a tree of the
/// map. As many poses as frames. Source: Nevalainen2021 Eq. 33.
[[nodiscard]] FrameShares frame_shares(std::span<const SparseFrame> frames,
                                       const FramePoses& T_first_frame,
                                       const ClusterSettings& settings);

/// Positions of the `count` frames of the largest share, rising; the first frame, which carries
/// the map, is never among them. Of equal shares the earlier. Fewer where there are fewer.
[[nodiscard]] std::vector<std::size_t> worst_frames(const FrameShares& shares, std::size_t count);

/// Removes the frames at `positions` (rising) together with their poses.
void remove_frames(std::vector<SparseFrame>& frames, FramePoses& T_first_frame,
                   std::span<const std::size_t> positions);

}  // namespace honka
