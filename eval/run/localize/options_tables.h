#pragma once

#include <vector>

#include "eval/io/table.h"
#include "eval/report/report_model.h"
#include "eval/report/summary.h"
#include "eval/run/localize/options_study.h"

namespace honka::eval {

/// The answers of one case over all stands.
struct OptionsRow {
  OptionsCase what;
  std::vector<OptionsAnswer> answers;
  std::int64_t stems_in_map = 0;  ///< of the last stand
};

/// One row an answer, in the order of cases, stands and queries.
[[nodiscard]] Table options_answer_table(const std::vector<OptionsRow>& rows);
[[nodiscard]] Table selection_row_table(const std::vector<SelectionComparison>& rows);

[[nodiscard]] SummaryTable options_json(const std::vector<OptionsRow>& rows,
                                        const Scenario& scenario);
[[nodiscard]] SummaryTable selections_json(const std::vector<SelectionComparison>& rows);
[[nodiscard]] ReportTable options_table(const std::vector<OptionsRow>& rows);
[[nodiscard]] ReportTable selections_table(const std::vector<SelectionComparison>& rows);
[[nodiscard]] std::vector<std::string> options_protocol(const Scenario& scenario);

}  // namespace honka::eval
