#pragma once

#include <string>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/report/summary.h"
#include "eval/run/localize/map_update_summary.h"

namespace honka::eval {

/// tables.map_update: one row a (thinning, method, map, part).
[[nodiscard]] SummaryTable map_update_json(const std::vector<MapUpdateSummary>& summaries,
                                           const Scenario& scenario);
/// tables.map_quality: one row a (thinning, feeding matcher, part).
[[nodiscard]] SummaryTable map_quality_json(const std::vector<MapQualitySummary>& summaries,
                                            const Scenario& scenario);

[[nodiscard]] ReportTable map_update_table(const std::vector<MapUpdateSummary>& summaries,
                                           const Scenario& scenario);
[[nodiscard]] ReportTable map_quality_table(const std::vector<MapQualitySummary>& summaries,
                                            const Scenario& scenario);
[[nodiscard]] std::vector<std::string> map_update_protocol(const Scenario& scenario);

}  // namespace honka::eval
