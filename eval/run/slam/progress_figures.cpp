#include "eval/run/slam/progress_figures.h"

#include <fmt/format.h>

#include <cmath>

#include "eval/report/figure_trajectories.h"

namespace honka::eval {
namespace {

/// Points of a figure that were measured, over the corrections so far.
std::vector<Eigen::Vector2d> measured_points(const ProgressTrack& track, double MapFigures::*of) {
  std::vector<Eigen::Vector2d> points;
  for (const ProgressPoint& point : track.points) {
    if (!std::isfinite(point.map.*of)) continue;
    points.emplace_back(static_cast<double>(point.applied), point.map.*of);
  }
  return points;
}

CurvesPanel progress_panel(const std::string& label, double MapFigures::*of,
                           const std::vector<const ProgressTrack*>& tracks, bool with_floor) {
  CurvesPanel panel{label, {}};
  double last = 1.0;
  for (const ProgressTrack* track : tracks) {
    panel.curves.push_back({track->side, measured_points(*track, of)});
    last = std::max(last, static_cast<double>(track->points.back().applied));
  }
  const double floor = tracks.empty() ? 0.0 : tracks.front()->floor.*of;
  if (with_floor && std::isfinite(floor)) {
    panel.curves.push_back({"true poses", {{0.0, floor}, {last, floor}}});
  }
  return panel;
}

}  // namespace

ReportFigure draw_progress(const std::filesystem::path& folder,
                           const std::vector<ProgressTrack>& tracks) {
  std::vector<const ProgressTrack*> first;
  for (const ProgressTrack& track : tracks) {
    if (track.trial == tracks.front().trial) first.push_back(&track);
  }
  const std::int64_t rounds = first.empty() ? 0 : first.front()->points.back().round;
  CurvesFigure figure;
  figure.name = "progress";
  figure.title = "The loop over its corrections";
  figure.protocol = fmt::format(
      "{} rounds, nothing ends them early; update on the right and on the left", rounds);
  figure.x_label = "corrections applied";
  figure.caption =
      "β, registration noise, box-counting dimension, mean step error and ATE after each "
      "correction of the first trial, beside those of the same frames at their true poses.";
  figure.panels = {progress_panel("β", &MapFigures::blur, first, true),
                   progress_panel("e_C (m)", &MapFigures::cluster_rmse_m, first, true),
                   progress_panel("d", &MapFigures::dimension, first, true),
                   progress_panel("step error e (m)", &MapFigures::step_error_m, first, true),
                   progress_panel("ATE (m)", &MapFigures::ate_m, first, false)};
  return draw_curves(folder, figure);
}

}  // namespace honka::eval
