#pragma once

#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/report/summary.h"
#include "eval/run/localize/sighting_summary.h"

namespace honka::eval {

/// One sentence each: what the figures of this scenario mean.
[[nodiscard]] std::vector<std::string> sighting_protocol(const Scenario& scenario);

/// tables.<scenario> of summary.json.
[[nodiscard]] SummaryTable sighting_json(const std::vector<SightingSummary>& summaries,
                                         const Scenario& scenario);

/// The same for the report and the terminal: what came out, and what the maps cost.
[[nodiscard]] ReportTable sighting_report_table(const std::vector<SightingSummary>& summaries,
                                                const Scenario& scenario, const std::string& title);
[[nodiscard]] ReportTable sighting_cost_table(const std::vector<SightingSummary>& summaries);

}  // namespace honka::eval
