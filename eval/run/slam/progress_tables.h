#pragma once

#include <string>
#include <vector>

#include "eval/io/table.h"
#include "eval/report/summary.h"
#include "eval/run/slam/progress_claims.h"

namespace honka::eval {

/// One sentence each: what the figures of the progress experiment mean.
[[nodiscard]] std::vector<std::string> progress_protocol();

/// The end of each round, means over the trials.
[[nodiscard]] ReportTable progress_table(const std::vector<ProgressTrack>& tracks);
[[nodiscard]] ReportTable progress_claims_table(const std::vector<ProgressClaim>& claims);

/// tables.progress and tables.progress_claims of summary.json.
[[nodiscard]] SummaryTable progress_json(const std::vector<ProgressTrack>& tracks);
[[nodiscard]] SummaryTable progress_claims_json(const std::vector<ProgressClaim>& claims);

/// /trials: one row a track. /frames: one row a point of a track, `trial` naming its row there.
[[nodiscard]] Table progress_trial_table(const std::vector<ProgressTrack>& tracks);
[[nodiscard]] Table progress_point_table(const std::vector<ProgressTrack>& tracks);

}  // namespace honka::eval
