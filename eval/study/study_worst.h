#pragma once

#include "eval/report/report_model.h"
#include "eval/study/study.h"

namespace honka::eval {

/// The trials to look at, each with the command that runs it again: failed ones, then answers that
/// were wrong, then the largest errors; some of each.
[[nodiscard]] ReportTable worst_trials(const Study& study, const Table& trials);

}  // namespace honka::eval
