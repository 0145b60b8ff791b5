#pragma once

#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/report/summary.h"
#include "eval/run/localization_summary.h"

namespace honka::eval {

/// Matchers side by side on the same stems: tables.<scenario> of summary.json.
[[nodiscard]] SummaryTable matcher_comparison_json(
    const std::vector<LocalizationSummary>& summaries, const Scenario& scenario);

/// The same for the report and the terminal.
[[nodiscard]] ReportTable matcher_comparison_table(
    const std::vector<LocalizationSummary>& summaries, const Scenario& scenario);

}  // namespace honka::eval
