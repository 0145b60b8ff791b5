#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/localize/tracking_case.h"

namespace honka::eval {

/// The way from above with 2 s.d. ellipses; error, 2 s.d. and events over time; NEES over time.
[[nodiscard]] std::vector<ReportFigure> draw_tracking(const std::filesystem::path& folder,
                                                      const TrackingDrive& drive,
                                                      const TrackedRun& run);

}  // namespace honka::eval
