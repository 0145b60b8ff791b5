#include "eval/run/slam/progress_record.h"

#include <cmath>

#include "algo/slam/map_quality/box_counting.h"
#include "algo/slam/map_quality/clusters.h"
#include "algo/slam/map_quality/live_map.h"
#include "eval/metrics/statistics.h"
#include "eval/metrics/trajectory_errors.h"
#include "eval/run/slam/slam_quality.h"

namespace honka::eval {
namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

ClusterSettings tight_clusters() {
  ClusterSettings settings;
  settings.link_m = 0.5;
  return settings;
}

double ate_of(const SlamDrive& drive, const FramePoses& T_first_frame) {
  const TrajectoryErrors errors = absolute_errors(laid_on_truth(drive, T_first_frame));
  return rmse(errors.translation_m).value_or(kNotMeasured);
}

/// Follows a map through the loop; what a correction did not touch is not measured again.
class MapWatch {
 public:
  MapWatch(const SlamDrive& drive, const FramePoses& T_first_frame, const SlamSettings& settings)
      : drive_(drive), settings_(settings), map_(drive.frames, T_first_frame, settings.loop.blur) {
    step_errors_m_.assign(drive.frames.empty() ? 0 : drive.frames.size() - 1, kNotMeasured);
    judge_steps(0, step_errors_m_.size());
  }

  /// The frames after j and up to i were squeezed, those after i follow.
  void move(std::size_t j, std::size_t i, const FramePoses& T_first_frame) {
    map_.move_after(j, T_first_frame);
    judge_steps(j, i);
  }

  [[nodiscard]] MapFigures figures(bool with_noise) const {
    MapFigures figures;
    if (!std::isfinite(map_.blur())) return figures;  // no points
    figures.blur = map_.blur();
    figures.dimension = box_dimension(map_.points_m(), {});
    figures.two_scale_dimension = two_scale_dimension(map_.points_m(), 0.2, 10.0);
    figures.ate_m = ate_of(drive_, map_.poses());
    std::vector<double> judged;
    for (const double error : step_errors_m_) {
      if (std::isfinite(error)) judged.push_back(error);
    }
    figures.step_error_m = mean(judged).value_or(kNotMeasured);
    if (with_noise) measure_noise(figures);
    return figures;
  }

  /// e_C of the map as it stands.
  void measure_noise(MapFigures& figures) const {
    const RegistrationNoise noise = registration_noise(map_.points_m(), tight_clusters());
    if (noise.clusters > 0) figures.cluster_rmse_m = noise.mean_rmse_m;
  }

 private:
  /// Steps l → l + 1 for l from `first` to below `end`.
  void judge_steps(std::size_t first, std::size_t end) {
    for (std::size_t l = first; l < end; ++l) {
      step_errors_m_[l] =
          judge_match(drive_.frames[l].points_m, drive_.frames[l + 1].points_m,
                      between(map_.poses(), l, l + 1), settings_.view, settings_.loop.quality)
              .error_m;
    }
  }

  const SlamDrive& drive_;
  const SlamSettings& settings_;
  LiveMap map_;
  std::vector<double> step_errors_m_;
};

}  // namespace

const ProgressPoint& ProgressTrack::end_of_round(std::int64_t round) const {
  const ProgressPoint* last = &points.front();
  for (const ProgressPoint& point : points) {
    if (point.round <= round) last = &point;
  }
  return *last;
}

ProgressTrack record_progress(const SlamDrive& drive, const FramePoses& T_first_frame,
                              const SlamSettings& settings, const std::string& side,
                              std::uint64_t seed) {
  ProgressTrack track;
  track.side = side;
  track.frames = drive.frames.size();
  track.floor = MapWatch(drive, drive.true_T_first_frame, settings).figures(true);
  MapWatch watch(drive, T_first_frame, settings);
  track.points.push_back({0, 0, 0, 0, watch.figures(true)});

  PaperLoopSettings loop = settings.loop;
  loop.side = side;
  ProgressPoint now;
  const auto observer = [&](const CorrectionReport& report, const FramePoses& poses) {
    const bool moved_map = report.outcome == CorrectionOutcome::kApplied;
    if (report.round + 1 != now.round) watch.measure_noise(track.points.back().map);
    now.round = report.round + 1;
    now.tried = report.number + 1;
    now.applied += moved_map ? 1 : 0;
    now.go_icp_calls += report.used_go_icp ? 1 : 0;
    if (moved_map) watch.move(report.pair.j, report.pair.i, poses);
    now.map = watch.figures(moved_map && now.applied % kNoiseEvery == 0);
    track.points.push_back(now);
  };
  (void)run_paper_loop(drive.frames, T_first_frame, settings.view, loop, seed, observer);
  watch.measure_noise(track.points.back().map);
  return track;
}

}  // namespace honka::eval
