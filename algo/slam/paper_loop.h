#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algo/slam/correction/candidate_pairs.h"
#include "algo/slam/correction/power_coefficients.h"
#include "algo/slam/map_quality/blur.h"
#include "algo/slam/registration/go_icp.h"

namespace honka {

/// Go-ICP as the paper runs it: leaves of (δ0, θ0), and no clock in the answer.
[[nodiscard]] GoIcpSettings paper_go_icp();

/// The iterative improvement of Nevalainen2021, with the choices that its text leaves open as keys.
struct PaperLoopSettings {
  PaperLoopSettings();
  CandidatePairSettings pairs;
  std::int64_t corrections = 100;           ///< m, pairs chosen in a round
  std::string order = "medium_gaps_first";  ///< small_gaps_first | medium_gaps_first | random
  std::string coefficient = "index";        ///< index | path | errors | metric | nearest
  std::string side = "right";               ///< right | left
  std::string acceptance = "always";        ///< always | error_falls | blur_falls
  double match_overlap_limit = 0.4;         ///< λ of a match below which it is not used
  double max_blur_rise = 0.0;  ///< blur guard: share of β one correction may add; 0: off
  bool use_go_icp = true;      ///< where Eq. 27 is not met
  std::int64_t rounds = 1;
  std::int64_t patience = 0;  ///< corrections without a new least β that end the loop; 0: none do
  MatchQualitySettings quality;
  TrimmedIcpSettings icp;
  GoIcpSettings go_icp = paper_go_icp();
  BlurSettings blur;
  MotionMetric metric;
};
void describe(SettingsVisitor& v, PaperLoopSettings& s);

enum class CorrectionOutcome : std::uint8_t {
  kApplied,
  kNotRegistered,     ///< neither ICP nor Go-ICP gave a pose
  kTooLittleOverlap,  ///< of the view cones at the matched pose
  kErrorDidNotFall,   ///< acceptance = error_falls
  kBlurDidNotFall,    ///< acceptance = blur_falls
  kStoppedByBlurGuard,
};
/// applied | not_registered | too_little_overlap | error_did_not_fall | blur_did_not_fall |
/// stopped_by_blur_guard
[[nodiscard]] std::string_view correction_outcome_name(CorrectionOutcome outcome);

/// What became of one chosen pair.
struct CorrectionReport {
  std::int64_t round = 0;   ///< from 0
  std::int64_t number = 0;  ///< over all rounds, from 0
  FramePair pair;           ///< λ and e as they were when it was chosen
  CorrectionOutcome outcome = CorrectionOutcome::kNotRegistered;
  bool used_go_icp = false;
  double error_before_m = 0.0;  ///< e at the map's pose just before
  double error_m = 0.0;         ///< e at the matched pose
  double overlap = 0.0;         ///< λ there
  double blur = 0.0;            ///< β of the map after this pair, whatever its outcome
};

/// Called after each chosen pair with the map as it then stands.
using CorrectionObserver = std::function<void(const CorrectionReport&, const FramePoses&)>;

struct PaperLoopResult {
  FramePoses T_first_frame;
  double blur_before = 0.0, blur = 0.0;  ///< β; infinite for a map without points
  std::int64_t pairs_tried = 0;          ///< random pairs looked at, over all rounds
  std::int64_t candidates = 0, chosen = 0, applied = 0;
  std::int64_t icp_calls = 0, go_icp_calls = 0;
  double icp_s = 0.0, go_icp_s = 0.0;  ///< wall clock of these calls
  bool ended_early = false;            ///< by `patience`; the poses are then those of the least β
};

/// Improves a map: candidate pairs → choice → order → for each: trimmed ICP, Go-ICP where Eq. 27 is
/// not met, acceptance, update, blur guard; again for each round. As many poses as frames, finite;
/// the first stays. Frames that cannot be registered take part in no correction. The digits depend
/// on the arguments alone. Source: Nevalainen2021 §2.4.
[[nodiscard]] PaperLoopResult run_paper_loop(std::span<const SparseFrame> frames,
                                             const FramePoses& T_first_frame, const ViewCone& cone,
                                             const PaperLoopSettings& settings, std::uint64_t seed,
                                             const CorrectionObserver& observer = {});

}  // namespace honka
