#include "eval/run/localize/tracking_figures.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "eval/metrics/localization.h"
#include "eval/report/gnuplot.h"
#include "eval/run/localize/tracking_rows.h"

namespace honka::eval {
namespace {

constexpr double kRight_m = 0.5;              // a fix farther off is drawn as wrong
constexpr std::size_t kScansAnEllipse = 100;  // 10 s at 10 Hz

std::string run_name(const TrackedRun& run) {
  return run.what.method + (run.what.with_prior ? ", prior of the track" : "");
}

/// The outline that holds 2 s.d. of a pose's position, enlarged.
std::vector<Eigen::Vector2d> position_ellipse(const Belief& belief, double scale) {
  const Eigen::Matrix2d position = belief.covariance.topLeftCorner<2, 2>();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(position);
  const Eigen::Matrix2d root = axes.operatorSqrt();
  std::vector<Eigen::Vector2d> outline;
  for (int k = 0; k <= 36; ++k) {
    const double angle = 2.0 * kPi * k / 36.0;
    outline.emplace_back(belief.T_map_lidar.translation_m +
                         2.0 * scale * root * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return outline;
}

/// Truth and track; a new line where there was no pose and where a pose jumped.
struct TrackLines {
  std::vector<std::vector<Eigen::Vector2d>> truth, track, ellipses;
};

/// Appends a point to the last line, or begins one where it is too far away to have been driven.
void extend_lines(std::vector<std::vector<Eigen::Vector2d>>& lines, const Eigen::Vector2d& point,
                  bool begins) {
  constexpr double kJump_m = 2.0;
  if (begins || lines.empty() || (point - lines.back().back()).norm() > kJump_m) {
    lines.emplace_back();
  }
  lines.back().push_back(point);
}

TrackLines track_lines(const TrackingDrive& drive, const TrackedRun& run, double scale) {
  TrackLines lines;
  bool had_pose = false;
  for (std::size_t k = 0; k < run.poses.size(); ++k) {
    const TrackedPose& pose = run.poses[k];
    extend_lines(lines.truth, drive.scans[k].T_world_lidar.translation_m, k == 0);
    if (pose.has_pose()) {
      extend_lines(lines.track, pose.belief.T_map_lidar.translation_m, !had_pose);
      if (k % kScansAnEllipse == 0) lines.ellipses.push_back(position_ellipse(pose.belief, scale));
    }
    had_pose = pose.has_pose();
  }
  return lines;
}

std::vector<Eigen::Vector2d> wrong_fixes(const TrackedRun& run) {
  std::vector<Eigen::Vector2d> places;
  for (const TrackedLocalization& one : run.localizations) {
    if (one.accepted && one.error_m > kRight_m) places.push_back(one.T_map_local.translation_m);
  }
  return places;
}

ReportFigure draw_way(const std::filesystem::path& folder, const TrackingDrive& drive,
                      const TrackedRun& run) {
  constexpr double kScale = 10.0;
  const TrackLines lines = track_lines(drive, run, kScale);
  Figure figure(folder, "tracking_way", 900, 1100);
  figure.title("The tracked way", run_name(run) + "; ellipses: 2 s.d. × 10, every 10 s");
  figure << "set size ratio -1"
         << "set xlabel 'x (m)'"
         << "set ylabel 'y (m)'";
  figure.key_below(150);
  std::vector<std::string> elements = {figure.data("stems of the map", drive.map_m) +
                                       " with points pt 7 ps 0.25 lc '#C8C8C8' title "
                                       "'map'"};
  if (!drive.hidden_m.empty()) {
    elements.push_back(figure.data("stems left out of the map", drive.hidden_m) +
                       " with points pt 6 ps 0.4 lc " + kSky + " title 'left out of the map'");
  }
  elements.push_back(figure.lines("truth: x y", lines.truth) + " with lines lw 5 lc " + kGrey +
                     " title 'truth'");
  if (!lines.track.empty()) {
    elements.push_back(figure.lines("track: x y", lines.track) + " with lines lw 1.6 lc " + kBlue +
                       " title 'track'");
  }
  if (!lines.ellipses.empty()) {
    elements.push_back(figure.lines("2 s.d. × 10", lines.ellipses) + " with lines lw 1.2 lc " +
                       kOrange + " title '2 s.d. × 10'");
  }
  const auto wrong = wrong_fixes(run);
  if (!wrong.empty()) {
    elements.push_back(figure.data("accepted, wrong", wrong) + " with points pt 2 ps 0.8 lc " +
                       kRed + " title 'accepted, but wrong'");
  }
  figure.plot(elements);
  return figure.draw("The tracked way",
                     "Truth and track from above, with the stems of the map and those left out of "
                     "it.");
}

/// A vertical line and a word for each event.
void mark_events(Figure& figure, const TrackingDrive& drive, const TrackedRun& run, bool words) {
  const auto line = [&](double time_s, const std::string& style) {
    figure << "set arrow from " + number(time_s) + ", graph 0 to " + number(time_s) +
                  ", graph 1 nohead " + style;
  };
  if (drive.kidnapped_s >= 0.0) line(drive.kidnapped_s, std::string("lw 2 lc ") + kRed);
  double row = 0.97;
  for (const TrackEvent& event : run.events) {
    line(event.time_s, std::string("dt 2 lc ") + kGrey);
    if (!words) continue;
    figure << "set label " + gnuplot_text(fmt::format(" {}", name_of(event.kind))) + " at " +
                  number(event.time_s) + ", graph " + number(row) + " font ',10'";
    row = row < 0.7 ? 0.97 : row - 0.07;
  }
}

struct TrackCurves {
  std::vector<double> time_s, error_m, bound_m, nees;
};

TrackCurves track_curves(const TrackingDrive& drive, const TrackedRun& run) {
  TrackCurves curves;
  for (std::size_t k = 0; k < run.poses.size(); ++k) {
    const TrackedPose& pose = run.poses[k];
    const Pose2& truth = drive.scans[k].T_world_lidar;
    const bool has = pose.has_pose();
    curves.time_s.push_back(pose.time_s);
    curves.error_m.push_back(has ? pose_error(pose.belief.T_map_lidar, truth).translation_m : NAN);
    curves.bound_m.push_back(has ? 2.0 * largest_position_sigma_m(pose.belief) : NAN);
    curves.nees.push_back(has ? nees_of(pose, truth) : NAN);
  }
  return curves;
}

ReportFigure draw_errors(const std::filesystem::path& folder, const TrackingDrive& drive,
                         const TrackedRun& run) {
  const TrackCurves curves = track_curves(drive, run);
  std::vector<double> fix_s, fix_m;
  for (const TrackedLocalization& one : run.localizations) {
    if (!one.accepted) continue;
    fix_s.push_back(drive.scans[one.scan].time_s);
    fix_m.push_back(one.error_m);
  }
  Figure figure(folder, "tracking_errors", 1100, 560);
  figure.title("Position error of the track",
               run_name(run) + "; red line: the kidnapping; dashed: events");
  figure << "set logscale y"
         << "set yrange [0.001:300]"
         << "set xlabel 'time (s)'"
         << "set ylabel 'error (m)'";
  figure.key_below(95);
  mark_events(figure, drive, run, true);
  std::vector<std::string> elements = {
      figure.data("time s, 2 s.d. m", {curves.time_s, curves.bound_m}) +
          " with filledcurves y1=0.001 fc '#DCEBF7' title '2 s.d.'",
      figure.data("time s, error m", {curves.time_s, curves.error_m}) + " with lines lw 1.4 lc " +
          kBlue + " title 'error of the track'"};
  const bool any = std::any_of(curves.error_m.begin(), curves.error_m.end(),
                               [](double value) { return std::isfinite(value); });
  if (!any) return figure.draw("Position error of the track", "No pose, no error.");
  if (!fix_s.empty()) {
    elements.push_back(figure.data("time s, error of a localization m", {fix_s, fix_m}) +
                       " with points pt 7 ps 0.35 lc " + kOrange +
                       " title 'accepted localizations'");
  }
  figure.plot(elements);
  return figure.draw("Position error of the track",
                     "Error of the position at every scan and its 2 s.d.; accepted localizations "
                     "as points.");
}

ReportFigure draw_nees(const std::filesystem::path& folder, const TrackingDrive& drive,
                       const TrackedRun& run) {
  const TrackCurves curves = track_curves(drive, run);
  Figure figure(folder, "tracking_nees", 1100, 420);
  figure.title("Normalized error squared of (x, y, yaw)",
               run_name(run) + "; an honest covariance has a mean of 3, and 95 % below 7.81");
  figure << "set logscale y"
         << "set yrange [0.01:1e4]"
         << "set xlabel 'time (s)'"
         << "set ylabel 'NEES'";
  figure.key_below(95);
  mark_events(figure, drive, run, false);
  const bool any = std::any_of(curves.nees.begin(), curves.nees.end(),
                               [](double value) { return std::isfinite(value); });
  if (!any) return figure.draw("Normalized error squared", "No pose, no error.");
  figure.plot({figure.data("time s, NEES", {curves.time_s, curves.nees}) + " with lines lc " +
                   kBlue + " title 'NEES'",
               std::string("3 with lines dt 3 lc ") + kBlack + " title '3'",
               std::string("7.815 with lines dt 2 lc ") + kRed + " title '95 %'"});
  return figure.draw("Normalized error squared", "NEES of the track at every scan.");
}

}  // namespace

std::vector<ReportFigure> draw_tracking(const std::filesystem::path& folder,
                                        const TrackingDrive& drive, const TrackedRun& run) {
  return {draw_way(folder, drive, run), draw_errors(folder, drive, run),
          draw_nees(folder, drive, run)};
}

}  // namespace honka::eval
