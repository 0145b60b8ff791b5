#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algo/slam/chain.h"
#include "algo/slam/match_quality.h"
#include "algo/slam/methods/interpolate_pairs.h"
#include "algo/slam/methods/landmark_ba.h"
#include "algo/slam/methods/pose_graph.h"
#include "algo/slam/methods/rechain.h"
#include "algo/slam/methods/stem_map.h"
#include "algo/slam/methods/verified_pairs.h"
#include "algo/slam/paper_loop.h"
#include "algo/slam/sparse_frame.h"
#include "algo/slam/view_cone.h"
#include "algo/types/settings.h"

namespace honka {

/// When the edge sends a frame: this far from the last one sent, by its own odometry.
struct SlamKeyFrameSettings {
  double distance_m = 0.25;
  double angle_deg = 3.0;
};
void describe(SettingsVisitor& v, SlamKeyFrameSettings& s);

/// Everything a scenario can say about SLAM.
struct SlamSettings {
  std::string method = "landmark_ba";  ///< a name of slam_method_names()
  std::string start = "by_method";     ///< chain | rechained | by_method
  SlamKeyFrameSettings keyframe;
  ViewCone view;
  MatchQualitySettings match;
  ChainSettings chain;
  PaperLoopSettings loop;
  RechainSettings rechain;
  VerifiedPairsSettings pairs;
  InterpolatePairsSettings interpolate;
  PoseGraphSettings pose_graph;
  StemMapSettings stem_map;
  LandmarkBaSettings landmark_ba;
};
void describe(SettingsVisitor& v, SlamSettings& s);

/// What became of a frame.
enum class FrameStatus : std::uint8_t {
  kPlaced,        ///< at its pose it passes the share test against a neighbour
  kUnverified,    ///< it does not: it hangs on its neighbours' poses alone
  kTooFewPoints,  ///< fewer than three distinct stems, or all on one line
  kNotFinite,     ///< it held NaN or infinity; those points were left out
};

/// placed | unverified | too_few_points | not_finite
[[nodiscard]] std::string_view frame_status_name(FrameStatus status);

/// How long a stage took.
struct StageTime {
  std::string stage;  ///< chain | rechain | pairs | loop | interpolate | pose_graph | …
  double seconds = 0.0;
};

/// A map made of frames. All poses are finite; the first is the identity.
struct SlamResult {
  FramePoses T_first_frame;
  std::vector<FrameStatus> frames;
  std::vector<MapStem> stems;
  std::vector<PairMatch> matches;  ///< verified matches that were used (not by `paper`)
  std::size_t corrections = 0;     ///< matches that moved the map
  std::size_t bad_steps = 0;       ///< of the re-registered chain: steps that failed their test
  std::size_t icp_calls = 0;       ///< for corrective matches
  std::size_t go_icp_calls = 0;
  std::vector<StageTime> times;
};

/// Told as a run goes on; every function may be left as it is.
class SlamObserver {
 public:
  virtual ~SlamObserver() = default;
  /// The poses after a stage (chain, rechain, …).
  virtual void after_stage(std::string_view /*stage*/, const FramePoses& /*T_first_frame*/) {}
  /// While a stage goes on (frames of the chain, rounds of the adjustment).
  virtual void during_stage(std::string_view /*stage*/, std::size_t /*done*/,
                            std::size_t /*total*/) {}
  /// After each pair that the paper's loop chose, with the map as it then stands.
  virtual void after_correction(const CorrectionReport& /*report*/,
                                const FramePoses& /*T_first_frame*/) {}
};

/// chain | paper | interpolate | pose_graph | landmark_ba
[[nodiscard]] const std::vector<std::string>& slam_method_names();

/// Lays all frames into one map.
///
/// `T_first_frame_chain`: the edge's own chain, one pose a frame (moved so that the first is the
/// identity); without it the chain is made by ChainSettings. Frames may hold any points, also none,
/// and also NaN or some beyond 1 km: such points are left out and the frame says so. The digits
/// depend on the arguments alone; the seed counts for `paper` alone. Throws UserError at an unknown
/// method or start, no frames, numbers of frames that do not rise, or a chain of another length or
/// with a pose that is not finite.
[[nodiscard]] SlamResult run_slam(std::span<const SparseFrame> frames,
                                  const std::optional<FramePoses>& T_first_frame_chain,
                                  const SlamSettings& settings, SlamObserver* observer = nullptr,
                                  std::uint64_t seed = 0);

}  // namespace honka
