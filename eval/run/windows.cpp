#include "eval/run/windows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "algo/types/check.h"
#include "eval/metrics/localization.h"
#include "eval/metrics/statistics.h"
#include "eval/metrics/stem_scores.h"
#include "eval/run/localize/map_bend.h"
#include "eval/run/star_survival.h"
#include "eval/run/stem_judgement.h"

namespace honka::eval {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Stems of a window's cloud by one form of Algorithm 1; variants that share it share this.
struct LocalStems {
  std::vector<ObservedStem> stems;
  std::vector<Eigen::Vector2d> positions_m;
  DelaunayGraph graph;
  StemScores scores;
  double extract_ms = 0.0;
};

LocalStems find_stems(const LocalCloud& cloud, const StemSettings& settings) {
  const auto start = Clock::now();
  LocalStems local;
  local.stems = extract_stems(cloud, settings).stems;
  local.extract_ms = milliseconds_since(start);
  for (const ObservedStem& stem : local.stems) local.positions_m.push_back(stem.position_m);
  local.graph = build_delaunay(local.positions_m);
  return local;
}

/// Cramér–Rao bound of the position, from the stems that stand in the map and the spread of their
/// distances to it.
std::optional<double> bound_m(const LocalStems& local, const TrunkMap& map,
                              const Pose2& T_map_local, double gate_m) {
  std::vector<Eigen::Vector2d> stems_in_map, partnered_in_local;
  for (const auto& position : local.positions_m) stems_in_map.push_back(T_map_local * position);
  std::vector<double> distances_m;
  for (const StemPair& pair : match_stems(stems_in_map, map.positions_m(), gate_m)) {
    partnered_in_local.push_back(local.positions_m[pair.found]);
    distances_m.push_back(pair.distance_m);
  }
  const auto spread_m = rmse(distances_m);
  if (!spread_m) return std::nullopt;
  const auto bound = cramer_rao_bound(partnered_in_local, *spread_m / std::sqrt(2.0));
  if (!bound) return std::nullopt;
  return bound->translation_m;
}

void judge_stems(LocalizationRow& row, const LocalStems& local) {
  for (std::size_t bin = 0; bin < row.detection.size(); ++bin) {
    row.detection[bin] = local.scores.by_range[bin].detection;
  }
  row.stem_rmse_m = local.scores.position_rmse_m;
}

void judge_pose(LocalizationRow& row, const Pose2& T_odom_local, const ProtocolSettings& protocol) {
  const PoseError to_truth = pose_error(row.T_map_local, row.T_world_local);
  const PoseError to_odometry = pose_error(row.T_map_local, T_odom_local);
  row.translation_error_m = to_truth.translation_m;
  row.rotation_error_rad = to_truth.rotation_rad;
  row.error_to_odometry_m = to_odometry.translation_m;
  row.rotation_to_odometry_rad = to_odometry.rotation_rad;
  row.success =
      judge(row.accepted, to_truth, {protocol.success_translation_m, protocol.success_rotation_deg})
          .success();
}

/// Against the map as it lies there: what the mapping run bent is not the matcher's error.
void judge_in_map(LocalizationRow& row, const LocalStems& local, const TrunkMap& map,
                  const StemMap& stems_in_world, double gate_m) {
  const auto T_map_world = map_bend(map, stems_in_world, row.T_world_local.translation_m, gate_m);
  row.error_in_map_m.reset();
  row.bound_in_map_m.reset();
  if (!T_map_world) return;
  const Pose2 T_map_local = *T_map_world * row.T_world_local;
  row.error_in_map_m = pose_error(row.T_map_local, T_map_local).translation_m;
  row.bound_in_map_m = bound_m(local, map, T_map_local, gate_m);
}

void localize(LocalizationRow& row, const Variant& variant, const LocalStems& local) {
  const auto start = Clock::now();
  const LocateResult result =
      variant.matcher ? variant.matcher->locate(local.positions_m) : LocateResult{};
  row.match_ms = milliseconds_since(start);
  row.extract_ms = local.extract_ms;
  row.variant = variant.name;
  row.method = variant.method;
  row.repaired = variant.map->repaired;
  row.stems_in_map = static_cast<std::int64_t>(variant.map->stems.size());
  row.map = variant.map->source;
  row.tolerance_m2 = variant.tolerance_m2;
  row.stems = static_cast<int>(local.stems.size());
  row.matches = result.matches;
  row.agreeing = result.agreeing;
  row.verdict = variant.matcher ? verdict_name(result.verdict) : "map_too_small";
  row.accepted = result.accepted();
  row.T_map_local = result.T_map_local;
}

/// Disjoint windows of so many key frames.
void add_windows(std::vector<Window>& windows, std::size_t key_frames,
                 const ProtocolSettings& protocol, std::int64_t length,
                 const std::vector<std::int64_t>& rows) {
  const auto width = static_cast<std::size_t>(length);
  const std::size_t available = key_frames / width;
  const std::size_t wanted = protocol.windows == 0
                                 ? available
                                 : std::min(available, static_cast<std::size_t>(protocol.windows));
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t place = i * available / wanted;
    const auto number = static_cast<std::int64_t>(windows.size());
    windows.push_back({number, place * width + width - 1, rows});
  }
}

}  // namespace

std::vector<Window> disjoint_windows(std::size_t key_frames, const ProtocolSettings& protocol) {
  HONKA_CHECK(!protocol.frames.empty(), "a protocol needs at least one number of frames");
  std::vector<Window> windows;
  if (protocol.windows_of == "each") {
    for (const std::int64_t n : protocol.frames) add_windows(windows, key_frames, protocol, n, {n});
  } else {
    const auto longest = *std::max_element(protocol.frames.begin(), protocol.frames.end());
    add_windows(windows, key_frames, protocol, longest, protocol.frames);
  }
  return windows;
}

LocalCloud window_cloud(const ScannedRun& run, const Window& window, std::int64_t frames,
                        const KeyFrameSettings& settings) {
  std::vector<PosedSweep> sweeps;
  const std::size_t first = window.last_key_frame + 1 - static_cast<std::size_t>(frames);
  for (std::size_t k = first; k <= window.last_key_frame; ++k) {
    const auto of_frame = posed(run.drive->key_frames[k], run.scans[k]);
    sweeps.insert(sweeps.end(), of_frame.begin(), of_frame.end());
  }
  return aggregate(sweeps, *run.model, settings,
                   run.drive->key_frames[window.last_key_frame].T_odom_lidar);
}

std::vector<LocalizationRow> localize_window(const Window& window, const ScannedRun& run,
                                             const std::vector<Variant>& variants,
                                             const Scenario& scenario, const WindowTruth& truth) {
  const KeyFrame& reference = run.drive->key_frames[window.last_key_frame];
  LocalizationRow row;
  row.trial = truth.trial;
  row.window = window.number;
  row.T_world_local = planar(levelled(reference.T_world_lidar));
  const double gate_m = scenario.protocol.stem_gate_m;
  const Pose2 T_odom_local = planar(run.drive->T_world_odom * levelled(reference.T_odom_lidar));

  std::vector<LocalizationRow> rows;
  for (const std::int64_t frames : window.frames) {
    row.frames = frames;
    const auto start = Clock::now();
    const LocalCloud cloud = window_cloud(run, window, frames, scenario.frame);
    row.aggregate_ms = milliseconds_since(start);
    std::optional<LocalStems> plain, repaired;
    for (const Variant& variant : variants) {
      std::optional<LocalStems>& local = variant.map->repaired ? repaired : plain;
      if (!local) {
        local = find_stems(cloud, variant.stems);
        local->scores = score_window(local->stems, *truth.stems_in_world, row.T_world_local,
                                     deg_to_rad(scenario.lidar.field_of_view_deg), gate_m);
      }
      const StarSurvival stars =
          star_survival(local->graph, variant.map->graph, row.T_world_local, gate_m);
      row.local_stars = stars.stars;
      row.surviving_stars = stars.surviving;
      localize(row, variant, *local);
      judge_stems(row, *local);
      row.bound_m = bound_m(*local, *variant.map, row.T_world_local, gate_m);
      judge_pose(row, T_odom_local, scenario.protocol);
      judge_in_map(row, *local, *variant.map, *truth.stems_in_world, gate_m);
      rows.push_back(row);
    }
  }
  return rows;
}

}  // namespace honka::eval
