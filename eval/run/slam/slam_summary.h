#pragma once

#include <optional>
#include <string>
#include <vector>

#include "eval/metrics/statistics.h"
#include "eval/run/slam/slam_trial.h"

namespace honka::eval {

/// A figure over the seeds: those that have it, in the order of trials.
struct SeedFigure {
  std::vector<double> values;

  [[nodiscard]] double mean_or_nan() const;
  /// Percentile bootstrap of the mean, 95 %; nothing for fewer than two seeds.
  [[nodiscard]] std::optional<Interval> interval() const;
};

/// What one case made over all seeds.
struct SlamSummaryRow {
  std::string start, treatment;
  SeedFigure blur, blur_floor;
  SeedFigure cluster_rmse_m, cluster_rmse_floor_m;        ///< link 1.0 m
  SeedFigure cluster_rmse_05_m, cluster_rmse_05_floor_m;  ///< link 0.5 m
  SeedFigure pooled_rmse_m, box_dimension, box_dimension_floor;
  SeedFigure ate_m, ate_planar_m, ate_deg;
  SeedFigure corrections, icp_calls, go_icp_calls, time_s, icp_ms, go_icp_ms;
  std::int64_t done = 0, trials = 0;
};

/// Rows in the order of the cases; trials without frames count in `trials` alone.
[[nodiscard]] std::vector<SlamSummaryRow> summarize_slam(const std::vector<SlamTrial>& trials,
                                                         const std::vector<SlamCase>& cases);

/// What Nevalainen2021 reports of its start and of its three orders (Table 1).
struct PaperSlamRow {
  std::string treatment;
  double blur = 0.0;
  std::optional<double> cluster_rmse_m, corrections;
};
[[nodiscard]] const std::vector<PaperSlamRow>& paper_slam_rows();
/// The paper's row of that treatment; null where it has none.
[[nodiscard]] const PaperSlamRow* paper_slam_row(const std::string& treatment);

}  // namespace honka::eval
