#include "algo/slam/methods/landmark_ba.h"

#include <algorithm>
#include <cmath>

#include "algo/slam/chain.h"
#include "algo/slam/methods/landmark_system.h"
#include "algo/types/angles.h"
#include "algo/types/check.h"

namespace honka {
namespace {

/// Conjugate gradients end here: the next Gauss–Newton step makes good what is left.
constexpr double kInnerTolerance = 1e-3;
constexpr int kInnerIterations = 200;
/// A round ends when a step lowers the cost by less than this part.
constexpr double kEnoughGain = 1e-5;

LandmarkWeights weights_of(const LandmarkBaSettings& s) {
  return {1.0 / s.planar_m, 1.0 / s.vertical_m, s.robust_scale, 1.0 / s.chain_m,
          1.0 / deg_to_rad(s.chain_deg)};
}

std::vector<ChainTie> ties_of(const FramePoses& T_first_frame,
                              std::span<const std::size_t> drive_starts) {
  std::vector<ChainTie> ties;
  for (std::size_t l = 0; l + 1 < T_first_frame.size(); ++l) {
    if (std::binary_search(drive_starts.begin(), drive_starts.end(), l + 1)) continue;
    ties.push_back({l, between(T_first_frame, l, l + 1)});
  }
  return ties;
}

bool finite(const LandmarkSystem::Step& step) {
  return std::all_of(step.poses.begin(), step.poses.end(),
                     [](const Twist& t) { return t.allFinite(); }) &&
         std::all_of(step.stems_m.begin(), step.stems_m.end(),
                     [](const Eigen::Vector3d& m) { return m.allFinite(); });
}

/// Poses and stems as the adjustment moves them.
struct Estimate {
  FramePoses poses;
  std::vector<Eigen::Vector3d> stems_m;

  [[nodiscard]] Estimate after(const LandmarkSystem::Step& step) const {
    Estimate next = *this;
    for (std::size_t i = 0; i < poses.size(); ++i) next.poses[i] = stepped(poses[i], step.poses[i]);
    for (std::size_t s = 0; s < stems_m.size(); ++s) next.stems_m[s] += step.stems_m[s];
    return next;
  }
};

/// Gauss–Newton with one association; a step that does not lower the cost is not taken.
void adjust_round(LandmarkSystem& system, Estimate& estimate, std::int64_t most,
                  LandmarkBaResult& result) {
  double cost = system.cost(estimate.poses, estimate.stems_m);
  result.initial_cost = cost;
  for (std::int64_t k = 0; k < most; ++k) {
    system.linearize(estimate.poses, estimate.stems_m);
    const LandmarkSystem::Step step = system.solve(kInnerTolerance, kInnerIterations);
    if (!finite(step)) break;
    Estimate next = estimate.after(step);
    const double next_cost = system.cost(next.poses, next.stems_m);
    ++result.iterations;
    if (!(next_cost < cost)) break;
    const bool settled = cost - next_cost <= kEnoughGain * cost;
    estimate = std::move(next);
    cost = next_cost;
    if (settled) break;
  }
  result.final_cost = cost;
}

/// The whole estimate moved so that the first pose is `first` again: the observations leave that
/// free, and conjugate gradients converge best where nothing is held.
void put_back(Estimate& estimate, const Pose3& first) {
  const Pose3 back = first * estimate.poses.front().inverse();
  for (Pose3& pose : estimate.poses) pose = back * pose;
  for (Eigen::Vector3d& stem_m : estimate.stems_m) stem_m = back * stem_m;
  estimate.poses.front() = first;
}

std::size_t count_free(const StemMap3& map, std::size_t frames) {
  std::vector<std::uint8_t> held(frames, 0);
  for (const StemObservation& o : map.observations) held[o.frame] = 1;
  return static_cast<std::size_t>(std::count(held.begin(), held.end(), 0));
}

}  // namespace

LandmarkBaResult adjust_landmarks(std::span<const SparseFrame> frames,
                                  const FramePoses& T_first_frame,
                                  const StemMapSettings& map_settings,
                                  const LandmarkBaSettings& settings,
                                  std::span<const std::size_t> drive_starts,
                                  const StageProgress& progress) {
  HONKA_CHECK(frames.size() == T_first_frame.size(), "one pose a frame");
  LandmarkBaResult result;
  Estimate estimate{T_first_frame, {}};
  const std::vector<ChainTie> chain = ties_of(T_first_frame, drive_starts);
  for (std::int64_t round = 0; round < settings.rounds && frames.size() > 1; ++round) {
    result.map = build_stem_map(frames, estimate.poses, map_settings);
    estimate.stems_m.clear();
    for (const MapStem& stem : result.map.stems) {
      estimate.stems_m.push_back(stem.position_in_first_m);
    }
    LandmarkSystem system(frames, result.map, chain, weights_of(settings));
    adjust_round(system, estimate, settings.iterations, result);
    put_back(estimate, T_first_frame.front());
    if (progress)
      progress(static_cast<std::size_t>(round + 1), static_cast<std::size_t>(settings.rounds));
  }
  result.T_first_frame = estimate.poses;
  if (frames.size() < 2 || settings.rounds == 0) {
    result.map = build_stem_map(frames, estimate.poses, map_settings);
  } else {
    for (std::size_t s = 0; s < result.map.stems.size(); ++s) {
      result.map.stems[s].position_in_first_m = estimate.stems_m[s];
    }
    measure_scatter(result.map, frames, result.T_first_frame);
  }
  result.free_frames = count_free(result.map, frames.size());
  return result;
}

}  // namespace honka
