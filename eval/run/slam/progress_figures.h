#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/slam/progress_record.h"

namespace honka::eval {

/// β, e_C, d, the mean step error and the ATE over the corrections of the first trial, both sides
/// beside their floors.
[[nodiscard]] ReportFigure draw_progress(const std::filesystem::path& folder,
                                         const std::vector<ProgressTrack>& tracks);

}  // namespace honka::eval
