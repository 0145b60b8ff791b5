#include "eval/run/odometry_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "eval/metrics/trajectory_alignment.h"
#include "eval/report/figure_trajectories.h"

namespace honka::eval {
namespace {

/// Points that a curve of a figure is drawn with.
constexpr std::size_t kCurvePoints = 3000;

std::vector<Eigen::Vector2d> track_from_above(const PosePairs& pairs, bool truth) {
  std::vector<Eigen::Vector2d> points;
  for (const PosePair& pair : pairs.poses) {
    points.emplace_back((truth ? pair.truth : pair.estimate).translation().head<2>());
  }
  return sampled(points, kCurvePoints);
}

std::vector<Eigen::Vector2d> over_time(const PosePairs& pairs, const std::vector<double>& errors) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    points.emplace_back(pairs.poses[i].time_s, errors[i]);
  }
  return sampled(points, kCurvePoints);
}

/// Lengths of the sub-paths that any score holds, rising.
std::vector<double> sub_path_lengths(const std::vector<OdometryScores>& scores) {
  std::vector<double> lengths;
  for (const OdometryScores& s : scores) {
    for (const SubPathError& error : s.sub_paths) lengths.push_back(error.length_m);
  }
  std::sort(lengths.begin(), lengths.end());
  lengths.erase(std::unique(lengths.begin(), lengths.end()), lengths.end());
  return lengths;
}

}  // namespace

ReportFigure draw_odometry_tracks(const std::filesystem::path& folder,
                                  const std::vector<OdometryRun>& runs) {
  TrajectoriesFigure figure;
  figure.name = "tracks_" + runs.front().stand;
  figure.title = "Tracks, stand " + runs.front().stand;
  figure.protocol = "first poses made equal, so that the ends show what has drifted";
  figure.curves.push_back({"truth", track_from_above(runs.front().pairs, true)});
  for (const OdometryRun& run : runs) {
    const AlignmentResult origin = align(run.pairs, Alignment::kOrigin);
    figure.curves.push_back(
        {run.odometry, track_from_above(moved(run.pairs, origin.T_truth_estimate), false)});
  }
  return draw_trajectories(folder, figure);
}

ReportFigure draw_odometry_errors(const std::filesystem::path& folder,
                                  const std::vector<OdometryRun>& runs) {
  CurvesFigure figure;
  figure.name = "errors_" + runs.front().stand;
  figure.title = "Error over time, stand " + runs.front().stand;
  figure.protocol = "after yaw + translation";
  figure.x_label = "time (s)";
  figure.caption = "Distance and angle between estimated and true pose of each sweep.";
  figure.panels = {{"position error (m)", {}}, {"rotation error (deg)", {}}};
  for (const OdometryRun& run : runs) {
    const TrajectoryErrors errors = absolute_errors(aligned_by_yaw(run.pairs));
    figure.panels[0].curves.push_back({run.odometry, over_time(run.pairs, errors.translation_m)});
    figure.panels[1].curves.push_back({run.odometry, over_time(run.pairs, errors.rotation_deg)});
  }
  return draw_curves(folder, figure);
}

std::vector<ReportFigure> draw_odometry_drift(const std::filesystem::path& folder,
                                              const std::vector<OdometryScores>& scores) {
  const std::vector<double> lengths = sub_path_lengths(scores);
  std::vector<ReportFigure> figures;
  for (const std::string& odometry : odometry_names()) {
    CurvesFigure figure;
    figure.name = "drift_" + odometry;
    figure.title = "Drift of " + odometry + " by length of the sub-path";
    figure.protocol = "means over sub-paths that start every metre driven";
    figure.x_label = "driven (m)";
    figure.caption = "Error of the motion over a sub-path, divided by its length.";
    figure.points = true;
    figure.panels = {{"drift (%)", {}}, {"drift (deg/m)", {}}};
    for (const OdometryScores& s : scores) {
      if (s.odometry != odometry) continue;
      Curve percent{s.stand, {}}, degrees{s.stand, {}};
      for (const double length_m : lengths) {
        const auto drift = mean_drift(s.sub_paths, length_m);
        if (!drift) continue;
        percent.points.emplace_back(length_m, drift->percent);
        degrees.points.emplace_back(length_m, drift->deg_per_m);
      }
      figure.panels[0].curves.push_back(std::move(percent));
      figure.panels[1].curves.push_back(std::move(degrees));
    }
    if (!figure.panels[0].curves.empty()) figures.push_back(draw_curves(folder, figure));
  }
  return figures;
}

}  // namespace honka::eval
