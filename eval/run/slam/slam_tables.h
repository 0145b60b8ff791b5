#pragma once

#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/report/report_model.h"
#include "eval/report/summary.h"
#include "eval/run/slam/slam_summary.h"

namespace honka::eval {

/// How each figure was taken, a line each.
[[nodiscard]] std::vector<std::string> slam_protocol(const Scenario& scenario);

/// Table 1: blur, map noise and path error by start and order, paper beside ours beside the floor.
[[nodiscard]] ReportTable slam_table1(const std::vector<SlamSummaryRow>& rows);
/// The methods side by side, with noise at both links, and time.
[[nodiscard]] ReportTable slam_methods_table(const std::vector<SlamSummaryRow>& rows);
/// What else was measured: pooled noise, dimension, rotation error, calls and their times.
[[nodiscard]] ReportTable slam_details_table(const std::vector<SlamSummaryRow>& rows);
/// Each order against small-gaps-first, seed by seed.
[[nodiscard]] ReportTable slam_orders_table(const std::vector<SlamTrial>& trials);
/// The drives: sweeps, key frames, stems a frame beside the paper's, the edge's own odometry.
[[nodiscard]] ReportTable slam_drives_table(const std::vector<SlamTrial>& trials);

/// tables.table1 and tables.methods of summary.json.
[[nodiscard]] SummaryTable slam_table1_json(const std::vector<SlamSummaryRow>& rows,
                                            const Scenario& scenario);
[[nodiscard]] SummaryTable slam_methods_json(const std::vector<SlamSummaryRow>& rows,
                                             const Scenario& scenario);

}  // namespace honka::eval
