#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/localization_summary.h"
#include "eval/run/localization_trial.h"

namespace honka::eval {

/// Figures of the world and of one window: the stand, the map cloud (Li2020, Fig. 1c), the stages
/// of Algorithm 1 (Fig. 5), matched stars (Fig. 6) and one pairing (Fig. 7).
[[nodiscard]] std::vector<ReportFigure> draw_exhibit(const std::filesystem::path& folder,
                                                     const TrialExhibit& exhibit,
                                                     const Scenario& scenario);

/// Figures over all windows: success, trunks (Fig. 8), matches (Fig. 9), accuracy against time
/// (Fig. 10), errors, stems by range, and the speed that each row keeps up with.
[[nodiscard]] std::vector<ReportFigure> draw_statistics(
    const std::filesystem::path& folder, const Table& frames,
    const std::vector<LocalizationSummary>& summaries,
    const std::vector<DetectionSummary>& detection);

}  // namespace honka::eval
