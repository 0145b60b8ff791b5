#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "algo/slam/match_quality.h"
#include "algo/slam/methods/stage_progress.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// How neighbours in the chain are registered anew.
struct RechainSettings {
  double inlier_ratio = 0.4;       ///< of the trimmed ICP
  double polish_distance_m = 0.4;  ///< pairs nearer than this in the plane are all fitted at last
  double min_share = 0.4;          ///< of the common view's points with a partner; below: no match
  double search_distance_m = 3.5;  ///< half side of the search around the prediction
  double search_turn_deg = 44.0;   ///< half of the headings tried
  double search_step_m = 0.7;      ///< of its lattice
  double search_step_deg = 4.0;
};
void describe(SettingsVisitor& v, RechainSettings& s);

/// How a step of the chain came about.
enum class StepStatus : std::uint8_t {
  kRegistered,    ///< ICP from the chain's own step passed the share test
  kSearched,      ///< a start found by the search around the prediction passed it
  kUnverified,    ///< nothing passed; the step is the prediction and counts little
  kTooFewPoints,  ///< a frame has nothing to register; the step is the prediction
};

/// registered | searched | unverified | too_few_points
[[nodiscard]] std::string_view step_status_name(StepStatus status);

/// A chain whose steps are known to be good or known to be bad. All poses are finite.
struct Rechain {
  FramePoses T_first_frame;
  std::vector<StepStatus> steps;  ///< steps[l] leads from frame l to l + 1
  [[nodiscard]] std::size_t bad_steps() const;
};

/// Registers each frame of a chain to its predecessor again: trimmed ICP, a polish with all near
/// pairs, the share test, and where that fails a search around the prediction (the last good step).
/// Frames must be finite (`clean_frames`). Source: choice, beyond Nevalainen2021.
[[nodiscard]] Rechain reregister_chain(std::span<const SparseFrame> frames,
                                       const FramePoses& T_first_frame, const ViewCone& cone,
                                       const MatchQualitySettings& quality,
                                       const RechainSettings& settings,
                                       const StageProgress& progress = {});

}  // namespace honka
