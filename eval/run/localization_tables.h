#pragma once

#include <vector>

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/localization_summary.h"

namespace honka::eval {

/// One sentence each: what the figures of this scenario mean. For the report and summary.json.
[[nodiscard]] std::vector<std::string> localization_protocol(const Scenario& scenario);

/// tables.table1 of summary.json: the default's rows first.
[[nodiscard]] SummaryTable localization_json(const std::vector<LocalizationSummary>& summaries,
                                             const Scenario& scenario);

/// Paper | ours for one variant.
[[nodiscard]] ReportTable paper_table(const std::vector<LocalizationSummary>& summaries,
                                      const std::string& variant, const std::string& title,
                                      const Scenario& scenario);

/// Every variant in one table, without the paper's figures.
[[nodiscard]] ReportTable variants_table(const std::vector<LocalizationSummary>& summaries);

/// Stems found by range.
[[nodiscard]] ReportTable detection_table(const std::vector<DetectionSummary>& summaries,
                                          const Scenario& scenario);

/// What the world, its scans and its maps were like, one row a stand.
[[nodiscard]] ReportTable world_table(const Table& trials);

/// How far the odometry of each trial's runs strayed, and what it could not register.
[[nodiscard]] ReportTable odometry_table(const Table& trials);

/// Median times of each stage.
[[nodiscard]] ReportTable time_table(const std::vector<LocalizationSummary>& summaries);

}  // namespace honka::eval
