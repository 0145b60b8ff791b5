#include "eval/run/slam/slam_figures.h"

#include <fmt/format.h>

#include "algo/slam/chain.h"
#include "eval/report/figure_slam_maps.h"
#include "eval/report/figure_trajectories.h"
#include "eval/report/gnuplot.h"

namespace honka::eval {
namespace {

SlamMapPanel map_panel(const std::string& label, const SlamDrive& drive,
                       const FramePoses& T_first_frame) {
  SlamMapPanel panel{label, map_points(drive.frames, T_first_frame), {}};
  for (const Eigen::Vector3d& place : path_of(T_first_frame)) {
    panel.path_m.emplace_back(place.head<2>());
  }
  return panel;
}

std::string run_label(const SlamRun& run) {
  return fmt::format("{}, {}: β {:.3f}, ATE {:.2f} m", run.start, run.treatment, run.quality.blur,
                     run.quality.ate_m);
}

/// The run whose end the paper's figure shows, or the last one.
const SlamRun& shown_end(const SlamTrial& trial) {
  for (const SlamRun& run : trial.runs) {
    if (run.start == trial.runs.front().start && run.treatment == "medium_gaps_first") return run;
  }
  return trial.runs.back();
}

std::vector<Eigen::Vector2d> path_on_truth(const SlamDrive& drive, const FramePoses& poses) {
  std::vector<Eigen::Vector2d> points;
  for (const PosePair& pair : laid_on_truth(drive, poses).poses) {
    points.emplace_back(pair.estimate.translation().head<2>());
  }
  return points;
}

}  // namespace

ReportFigure draw_slam_fig11(const std::filesystem::path& folder, const SlamTrial& trial) {
  const SlamRun &before = trial.runs.front(), &after = shown_end(trial);
  SlamMapsFigure figure;
  figure.name = "fig11";
  figure.title = "Figure 11: the map before and after";
  figure.protocol = fmt::format("trial {}, {} key frames", trial.trial, trial.drive.frames.size());
  figure.caption =
      "Every registration of a stem, black, and the path, red, in the first key frame. Below, the "
      "same points at the true poses: the floor.";
  figure.panels = {map_panel("start: " + run_label(before), trial.drive, before.T_first_frame),
                   map_panel("end: " + run_label(after), trial.drive, after.T_first_frame),
                   map_panel(fmt::format("true poses: β {:.3f}", trial.floor.blur), trial.drive,
                             trial.drive.true_T_first_frame)};
  return draw_slam_maps(folder, figure);
}

ReportFigure draw_slam_paths(const std::filesystem::path& folder, const SlamTrial& trial) {
  TrajectoriesFigure figure;
  figure.name = "paths";
  figure.title = fmt::format("Paths of trial {}", trial.trial);
  figure.protocol = "each laid rigidly onto the truth";
  figure.curves.push_back({"truth", path_on_truth(trial.drive, trial.drive.true_T_first_frame)});
  for (const SlamRun& run : trial.runs) {
    const bool shown =
        run.treatment == "none" || run.treatment == "landmark_ba" || &run == &shown_end(trial);
    if (!shown || run.start == "true_poses") continue;
    figure.curves.push_back({fmt::format("{} / {}", run.start, run.treatment),
                             path_on_truth(trial.drive, run.T_first_frame)});
  }
  return draw_trajectories(folder, figure);
}

ReportFigure draw_slam_blur(const std::filesystem::path& folder,
                            const std::vector<SlamSummaryRow>& rows) {
  Figure figure(folder, "blur", 1000, 420);
  figure.title("Blur by start and treatment", "means over seeds, 95 %; dashed: at true poses");
  std::vector<double> place, value, low, high, floor;
  std::string tics;
  for (const SlamSummaryRow& row : rows) {
    const double x = static_cast<double>(place.size());
    const Interval interval =
        row.blur.interval().value_or(Interval{row.blur.mean_or_nan(), row.blur.mean_or_nan()});
    place.push_back(x);
    value.push_back(row.blur.mean_or_nan());
    low.push_back(interval.low);
    high.push_back(interval.high);
    floor.push_back(row.blur_floor.mean_or_nan());
    tics += fmt::format("{}{} {}", tics.empty() ? "" : ", ",
                        gnuplot_text(row.start + " / " + row.treatment), x);
  }
  figure << "set xtics rotate by 30 right (" + tics + ")"
         << "set ylabel 'blur'"
         << "set logscale y"
         << fmt::format("set xrange [-0.5:{}]", static_cast<double>(place.size()) - 0.5)
         << "set bmargin 9"
         << "unset key";
  figure.plot({figure.data("row, mean, low, high", {place, value, low, high}) +
                   " using 1:2:3:4 with yerrorbars pt 7 ps 1.1 lw 1.6 lc " + kBlue,
               figure.data("row, floor", {place, floor}) + " with lines dt 2 lw 1.4 lc " + kGrey});
  return figure.draw("Blur by start and treatment",
                     "Blur of the map of all frames. The dashed line is the blur of the same "
                     "points at the true poses.");
}

}  // namespace honka::eval
