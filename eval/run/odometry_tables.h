#pragma once

#include <string>
#include <vector>

#include "eval/report/summary.h"
#include "eval/run/odometry_scores.h"

namespace honka::eval {

/// One sentence each: what the figures of the odometry experiment mean.
[[nodiscard]] std::vector<std::string> odometry_protocol();

/// tables.stands of summary.json.
[[nodiscard]] SummaryTable stands_json(const std::vector<OdometryScores>& scores);

/// Drift, real-time factor and lost sequences: the table that is asked for.
[[nodiscard]] ReportTable stands_table(const std::vector<OdometryScores>& scores);

/// Errors over a metre and over the drive, and drift by the length of the sub-path.
[[nodiscard]] ReportTable odometry_errors_table(const std::vector<OdometryScores>& scores);

/// What became of the sweeps, with causes, and their times.
[[nodiscard]] ReportTable odometry_sweeps_table(const std::vector<OdometryScores>& scores);

/// Every lost sequence.
[[nodiscard]] ReportTable lost_table(const std::vector<OdometryScores>& scores);

/// "few_features 3, jump 1"; "–" for none.
[[nodiscard]] std::string causes_text(const std::map<std::string, std::int64_t>& causes);

}  // namespace honka::eval
