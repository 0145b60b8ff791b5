#include "eval/run/slam/slam_summary.h"

#include <cmath>
#include <limits>

namespace honka::eval {
namespace {

void add_figure(SeedFigure& figure, double value) {
  if (std::isfinite(value)) figure.values.push_back(value);
}

void add_count(SeedFigure& figure, std::int64_t value) {
  figure.values.push_back(static_cast<double>(value));
}

/// Milliseconds a call, where there were calls.
void add_call_time(SeedFigure& figure, double seconds, std::int64_t calls) {
  if (calls > 0) figure.values.push_back(1e3 * seconds / static_cast<double>(calls));
}

void add_run(SlamSummaryRow& row, const SlamRun& run, const SlamQuality& floor) {
  const SlamQuality& q = run.quality;
  add_figure(row.blur, q.blur);
  add_figure(row.blur_floor, floor.blur);
  add_figure(row.cluster_rmse_m, q.cluster_rmse_m);
  add_figure(row.cluster_rmse_floor_m, floor.cluster_rmse_m);
  add_figure(row.cluster_rmse_05_m, q.cluster_rmse_05_m);
  add_figure(row.cluster_rmse_05_floor_m, floor.cluster_rmse_05_m);
  add_figure(row.pooled_rmse_m, q.pooled_rmse_m);
  add_figure(row.box_dimension, q.box_dimension);
  add_figure(row.box_dimension_floor, floor.box_dimension);
  add_figure(row.ate_m, q.ate_m);
  add_figure(row.ate_planar_m, q.ate_planar_m);
  add_figure(row.ate_deg, q.ate_deg);
  add_count(row.corrections, run.corrections);
  add_count(row.icp_calls, run.icp_calls);
  add_count(row.go_icp_calls, run.go_icp_calls);
  add_figure(row.time_s, run.time_s);
  add_call_time(row.icp_ms, run.icp_s, run.icp_calls);
  add_call_time(row.go_icp_ms, run.go_icp_s, run.go_icp_calls);
  ++row.done;
}

}  // namespace

double SeedFigure::mean_or_nan() const {
  return mean(values).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<Interval> SeedFigure::interval() const { return bootstrap_mean(values); }

std::vector<SlamSummaryRow> summarize_slam(const std::vector<SlamTrial>& trials,
                                           const std::vector<SlamCase>& cases) {
  std::vector<SlamSummaryRow> rows;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    SlamSummaryRow row;
    row.start = cases[i].start;
    row.treatment = cases[i].treatment;
    row.trials = static_cast<std::int64_t>(trials.size());
    for (const SlamTrial& trial : trials) {
      if (i < trial.runs.size()) add_run(row, trial.runs[i], trial.floor);
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

const std::vector<PaperSlamRow>& paper_slam_rows() {
  static const std::vector<PaperSlamRow> kRows = {
      {"none", 0.31, std::nullopt, std::nullopt},
      {"small_gaps_first", 0.035, 0.27, 119.0},
      {"medium_gaps_first", 0.022, 0.15, 71.0},
      {"random", 0.051, 0.19, 119.0},
  };
  return kRows;
}

const PaperSlamRow* paper_slam_row(const std::string& treatment) {
  for (const PaperSlamRow& row : paper_slam_rows()) {
    if (row.treatment == treatment) return &row;
  }
  return nullptr;
}

}  // namespace honka::eval
