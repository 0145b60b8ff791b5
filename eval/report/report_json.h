#pragma once

#include "eval/report/summary.h"

namespace honka::eval {

[[nodiscard]] Json to_json(const ReportModel& model);

/// Throws nlohmann's exceptions for what does not fit.
[[nodiscard]] ReportModel report_from_json(const Json& json);

}  // namespace honka::eval
