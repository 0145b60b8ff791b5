#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/slam/slam_summary.h"

namespace honka::eval {

/// Nevalainen2021, Figure 11: the map of the first start, below it the map after the corrections
/// (medium-gaps-first where that was run, else the last run), and below the same points at the
/// true poses.
[[nodiscard]] ReportFigure draw_slam_fig11(const std::filesystem::path& folder,
                                           const SlamTrial& trial);

/// The paths of a trial's starts and of its best end beside the truth, each laid onto it.
[[nodiscard]] ReportFigure draw_slam_paths(const std::filesystem::path& folder,
                                           const SlamTrial& trial);

/// Blur, map noise and path error of each treatment, start by start, means over seeds.
[[nodiscard]] ReportFigure draw_slam_blur(const std::filesystem::path& folder,
                                          const std::vector<SlamSummaryRow>& rows);

}  // namespace honka::eval
