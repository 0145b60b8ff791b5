#include "eval/run/slam/view_experiment.h"

#include <fmt/format.h>

#include <cmath>

#include "algo/slam/convergence.h"
#include "algo/types/user_error.h"
#include "eval/run/slam/figure_results.h"
#include "eval/run/slam/slam_drive.h"
#include "eval/run/slam/view_figures.h"

namespace honka::eval {
namespace {

constexpr double kRangeBinM = 2.0;
constexpr std::size_t kRangeBins = 20;

/// Adds a frame's points to the bins of range.
void gather_by_range(const SparseFrame& frame, std::vector<ViewRangeBin>& bins) {
  const NaturalNeighbours around = natural_neighbours(frame.points_m);
  for (std::size_t k = 0; k < frame.points_m.size(); ++k) {
    if (around.distance_m[k] == 0.0) continue;
    const auto bin = static_cast<std::size_t>(frame.points_m[k].head<2>().norm() / kRangeBinM);
    if (bin >= bins.size()) continue;
    bins[bin].all.add(around.distance_m[k]);
    if (!around.on_rim[k]) bins[bin].inner.add(around.distance_m[k]);
  }
}

std::vector<ViewRangeBin> distances_by_range(const std::vector<SparseFrame>& frames) {
  std::vector<ViewRangeBin> bins(kRangeBins);
  for (std::size_t k = 0; k < kRangeBins; ++k) {
    bins[k].range_m = kRangeBinM * (static_cast<double>(k) + 0.5);
  }
  for (const SparseFrame& frame : frames) gather_by_range(frame, bins);
  return bins;
}

/// L0 of a mean frame, and how many stems it holds.
ViewMeans means_of(const std::vector<SparseFrame>& frames) {
  RunningMean inner, all, stems;
  for (const SparseFrame& frame : frames) {
    stems.add(static_cast<double>(frame.points_m.size()));
    if (frame.points_m.size() < 3) continue;
    inner.add(mean_neighbour_distance_m(frame.points_m));
    all.add(mean_neighbour_distance_m(frame.points_m, Periphery::kCounted));
  }
  return {inner.mean(), all.mean(), stems.mean()};
}

/// The frame whose number of stems is nearest to the mean; the first of several.
const SparseFrame& typical_frame(const std::vector<SparseFrame>& frames, double stems) {
  const SparseFrame* best = &frames.front();
  for (const SparseFrame& frame : frames) {
    const auto miss = [&](const SparseFrame& f) {
      return std::abs(static_cast<double>(f.points_m.size()) - stems);
    };
    if (miss(frame) < miss(*best)) best = &frame;
  }
  return *best;
}

/// Over the ranges that the paper calls large and populated enough.
double mean_between(const std::vector<ViewRangeBin>& bins, double low_m, double high_m) {
  RunningMean mean;
  for (const ViewRangeBin& bin : bins) {
    if (bin.range_m > low_m && bin.range_m < high_m) mean.merge(bin.all);
  }
  return mean.mean();
}

Table view_rows(const std::vector<ViewRangeBin>& bins) {
  Table rows({{"range_m", "m", "middle of the bin", std::vector<double>{}},
              {"points", "", "of all frames", std::vector<std::int64_t>{}},
              {"distance_m", "m", "mean to natural neighbours", std::vector<double>{}},
              {"inner_points", "", "off the rim", std::vector<std::int64_t>{}},
              {"inner_distance_m", "m", "of these", std::vector<double>{}}});
  for (const ViewRangeBin& bin : bins) {
    rows.add_row(bin.range_m, bin.all.count, bin.all.mean(), bin.inner.count, bin.inner.mean());
  }
  return rows;
}

FigureResults make_view_figures(const RunRequest& request, const std::filesystem::path& figures) {
  const SlamDrive drive = drive_for_slam(request.resolved.scenario, request.trial.value_or(0),
                                         request.threads, "single view");
  if (drive.frames.empty()) throw UserError("the drive gave no key frame: nothing to look at");
  const ViewMeans means = means_of(drive.frames);
  const auto bins = distances_by_range(drive.frames);
  const SparseFrame& frame = typical_frame(drive.frames, means.stems);
  FigureResults results;
  results.table = "single_view";
  results.facts = {
      {"L0 of a frame, rim left out", "m", means.inner_m, 3.5, 2},
      {"L0 of a frame, rim counted", "m", means.all_m, {}, 2},
      {"L0 of the stand's true stems, rim left out",
       "m",
       mean_neighbour_distance_m(drive.true_stems_in_first_m),
       {},
       2},
      {"neighbours' distance at ranges of 10 to 26 m", "m", mean_between(bins, 10.0, 26.0), 3.5, 2},
      {"stems a frame", "", means.stems, 130.0, 1},
      {"key frames", "", static_cast<double>(drive.frames.size()), {}, 0}};
  results.figures = {draw_single_view(figures, frame), draw_range_distances(figures, bins, means)};
  results.notes = {"The paper gives 3.0 to 4.0 m for ranges of 10 to 26 m; 3.5 is their middle."};
  results.protocol = {
      "Distance: mean over a stem's natural neighbours, those that an edge of the planar Delaunay "
      "triangulation joins it to (Eq. 23 of the paper). Rim: stems of the convex hull and their "
      "natural neighbours.",
      fmt::format("Over all key frames of the drive, ranges in bins of {:g} m.", kRangeBinM)};
  results.rows = view_rows(bins);
  return results;
}

}  // namespace

RunOutcome run_view_experiment(const RunRequest& request) {
  return run_figure_experiment(request, make_view_figures);
}

}  // namespace honka::eval
