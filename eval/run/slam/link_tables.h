#pragma once

#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/slam/link_scores.h"

namespace honka::eval {

/// One sentence each: what the figures of the bandwidth study mean.
[[nodiscard]] std::vector<std::string> link_protocol();

/// Bytes a metre: raw packets and messages, beside the paper's recording.
[[nodiscard]] ReportTable link_need_table(const std::vector<LinkTrial>& trials);
[[nodiscard]] SummaryTable link_need_json(const std::vector<LinkTrial>& trials);

/// Map quality over one series: bandwidth, loss or delay.
[[nodiscard]] ReportTable link_series_table(const std::string& series,
                                            const std::vector<LinkScores>& scores);
[[nodiscard]] SummaryTable link_series_json(const std::string& series,
                                            const std::vector<LinkScores>& scores);

/// /trials: one row a trial, link and method.
[[nodiscard]] Table link_trial_table();
void append_link_rows(Table& table, const LinkTrial& trial);

}  // namespace honka::eval
