#pragma once

#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/slam/selection_trial.h"

namespace honka::eval {

/// One sentence each: what the figures of the selection mean.
[[nodiscard]] std::vector<std::string> selection_protocol();

/// One row a test of pairs, means over the trials.
[[nodiscard]] ReportTable selection_table(const std::vector<SelectionCase>& cases);
[[nodiscard]] SummaryTable selection_json(const std::vector<SelectionCase>& cases);

/// /trials: one row a case. /frames: one row a judged pair, `trial` naming its row there.
[[nodiscard]] Table selection_trial_table(const std::vector<SelectionCase>& cases);
[[nodiscard]] Table selection_pair_table(const std::vector<SelectionCase>& cases);

}  // namespace honka::eval
