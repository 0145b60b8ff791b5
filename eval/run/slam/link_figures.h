#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/slam/link_scores.h"

namespace honka::eval {

/// Position error, cluster RMSE and mapped stems against the bandwidth or the loss: one curve a
/// method and variant of the link, and the floor at true poses; bars where there are several
/// drives.
[[nodiscard]] ReportFigure draw_link_quality(const std::filesystem::path& folder,
                                             const std::string& series,
                                             const std::vector<LinkScores>& scores);

}  // namespace honka::eval
