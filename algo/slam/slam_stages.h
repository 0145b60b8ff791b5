#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "algo/slam/slam.h"

namespace honka {

/// A map in the making: what each stage reads and leaves.
struct SlamWork {
  std::vector<SparseFrame> frames;  ///< finite points only
  const SlamSettings& settings;
  SlamObserver* observer = nullptr;
  std::uint64_t seed = 0;
  FramePoses poses = {};
  std::vector<std::uint8_t> bad_steps = {};  ///< of the chain, where they are known; else empty
  std::optional<StemMap3> stems = {};        ///< where a stage has made them already
  SlamResult result = {};
};

/// Frames with the points that no lidar can have seen left out; each frame that had such is
/// kNotFinite, one that holds too little to be registered kTooFewPoints, every other kPlaced.
[[nodiscard]] std::vector<SparseFrame> clean_frames(std::span<const SparseFrame> frames,
                                                    std::vector<FrameStatus>& statuses);

/// The chain as given or as ChainSettings makes it. UserError for one that cannot be used.
void stage_chain(SlamWork& work, const std::optional<FramePoses>& given);
void stage_rechain(SlamWork& work);
void stage_paper_loop(SlamWork& work);
void stage_pairs(SlamWork& work);
void stage_interpolate(SlamWork& work);
void stage_pose_graph(SlamWork& work);
void stage_landmark_ba(SlamWork& work);
/// The stems of the map, and what became of each frame.
void stage_finish(SlamWork& work);

}  // namespace honka
