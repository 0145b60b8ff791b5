#pragma once

#include <string>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/study/study_json.h"

namespace honka::eval {

/// A row a point and method: rates, the first error, error over bound, time.
[[nodiscard]] ReportTable study_result_table(const Study& study, const StudySummary& summary);

/// Every error and mean with its interval, a row a point and method.
[[nodiscard]] ReportTable study_error_table(const Study& study, const StudySummary& summary);

/// A row a comparison of two methods, with its verdict.
[[nodiscard]] ReportTable study_pair_table(const Study& study, const StudySummary& summary);

/// Time and memory, a row a point and method.
[[nodiscard]] ReportTable study_cost_table(const Study& study, const StudySummary& summary);

/// Verdicts over all points together.
[[nodiscard]] std::vector<std::string> pooled_verdicts(const Study& study,
                                                       const StudySummary& summary);

/// What the terminal shows: a row a point and method, as many as fit, then the verdicts and the
/// width of the intervals.
[[nodiscard]] std::string study_console_text(const Study& study, const StudySummary& summary);

/// The values of a point as texts, one an axis.
[[nodiscard]] std::vector<std::string> axis_texts(const Study& study, std::int64_t point);

}  // namespace honka::eval
