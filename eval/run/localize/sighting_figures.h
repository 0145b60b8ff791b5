#pragma once

#include <filesystem>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/report/report_model.h"
#include "eval/run/localize/sighting_summary.h"

namespace honka::eval {

/// Success and error over bound by case and method, time by case or against map size, and one list
/// found and one refused by the last method, on their maps.
[[nodiscard]] std::vector<ReportFigure> draw_sighting_figures(
    const std::filesystem::path& folder, const Scenario& scenario,
    const std::vector<SightingCase>& cases, const std::vector<SightingSummary>& summaries,
    const Table& lists);

/// The figures by case; one row a case, from the top.
[[nodiscard]] ReportFigure draw_success_by_case(const std::filesystem::path& folder,
                                                const std::vector<SightingSummary>& summaries);
[[nodiscard]] ReportFigure draw_bound_by_case(const std::filesystem::path& folder,
                                              const std::vector<SightingSummary>& summaries);
[[nodiscard]] ReportFigure draw_time_by_case(const std::filesystem::path& folder,
                                             const std::vector<SightingSummary>& summaries);
/// Time of a query, of the map, log-log.
[[nodiscard]] ReportFigure draw_time_by_size(const std::filesystem::path& folder,
                                             const std::vector<SightingSummary>& summaries);

/// A list laid onto the map by an answer.
struct SightingExhibit {
  std::string name, title, verdict, caption;
  std::vector<Eigen::Vector2d> map_m, list_in_map_m, felled_or_false_in_map_m;
  Pose2 T_map_sensor;
  double range_m = 0.0;
};
[[nodiscard]] ReportFigure draw_sighting_exhibit(const std::filesystem::path& folder,
                                                 const SightingExhibit& exhibit);

}  // namespace honka::eval
