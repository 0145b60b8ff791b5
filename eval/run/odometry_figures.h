#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/odometry_scores.h"

namespace honka::eval {

/// The tracks of one stand from above, their first poses laid on the truth's.
[[nodiscard]] ReportFigure draw_odometry_tracks(const std::filesystem::path& folder,
                                                const std::vector<OdometryRun>& runs);

/// Position and rotation error of each odometry over the time of one stand's drive.
[[nodiscard]] ReportFigure draw_odometry_errors(const std::filesystem::path& folder,
                                                const std::vector<OdometryRun>& runs);

/// Drift over the length of the sub-paths: one panel for % and one for °/m an odometry.
[[nodiscard]] std::vector<ReportFigure> draw_odometry_drift(
    const std::filesystem::path& folder, const std::vector<OdometryScores>& scores);

}  // namespace honka::eval
