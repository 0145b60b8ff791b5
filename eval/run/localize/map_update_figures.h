#pragma once

#include <filesystem>
#include <vector>

#include "eval/report/report_model.h"
#include "eval/run/localize/map_update_summary.h"

namespace honka::eval {

/// A map before and after a drive, as pictures show it.
struct MapUpdateExhibit {
  double thinned_to_per_ha = 0.0;
  JudgedMap before, after;
};

/// Stems retired, wrongly retired and added, before and after.
[[nodiscard]] ReportFigure draw_map_before_after(const std::filesystem::path& folder,
                                                 const MapUpdateExhibit& exhibit);

/// Success of every method in every map along the drives, by a twentieth of them; a figure each
/// thinning.
[[nodiscard]] std::vector<ReportFigure> draw_success_along_drive(
    const std::filesystem::path& folder, const Scenario& scenario,
    const std::vector<MapUpdateDrive>& drives);

/// Precision, recall and felled stems retired at the end of each part.
[[nodiscard]] ReportFigure draw_map_quality(const std::filesystem::path& folder,
                                            const std::vector<MapQualitySummary>& summaries);

}  // namespace honka::eval
