#include "eval/run/localize/sighting_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "eval/run/localize/sighting_trial.h"
#include "eval/run/localize/timed_matcher.h"

namespace honka::eval {
namespace {

/// First list of the last method that has the wanted acceptance.
std::optional<std::size_t> first_row(const Table& lists, bool accepted) {
  if (lists.rows() == 0) return std::nullopt;
  const std::string& method = lists.strings("method").back();
  for (std::size_t row = 0; row < lists.rows(); ++row) {
    if (lists.strings("method")[row] == method && (lists.ints("accepted")[row] != 0) == accepted)
      return row;
  }
  return std::nullopt;
}

std::vector<Eigen::Vector2d> around(const std::vector<Eigen::Vector2d>& map_m,
                                    const Eigen::Vector2d& place_m, double radius_m) {
  std::vector<Eigen::Vector2d> near;
  for (const Eigen::Vector2d& stem_m : map_m) {
    if ((stem_m - place_m).norm() < radius_m) near.push_back(stem_m);
  }
  return near;
}

/// Asks once more what a row of the results holds: the same answer, for its picture.
SightingExhibit exhibit_of(const Scenario& scenario, const std::vector<SightingCase>& cases,
                           const Table& lists, std::size_t row) {
  const auto one = std::find_if(cases.begin(), cases.end(), [&](const SightingCase& c) {
    return c.name == lists.strings("case")[row];
  });
  const SightingWorld world = make_sighting_world(scenario, *one, lists.ints("trial")[row]);
  const SightingQuery query = make_sighting_query(scenario, *one, world, lists.ints("query")[row]);
  const std::string& method = lists.strings("method")[row];
  const TimedMatcher timed = make_timed_matcher(method, world.mapped->map_m, scenario.localize);
  const LocateResult result = timed.matcher->locate(query.list.stems_in_sensor_m);
  SightingExhibit exhibit;
  exhibit.title = fmt::format("A list that {} {}: {}", method,
                              result.accepted() ? "accepts" : "refuses", one->name);
  exhibit.verdict =
      fmt::format("{}; {} stems, {} with a partner, margin {:.2f}", verdict_name(result.verdict),
                  result.stems, result.inliers, result.margin);
  exhibit.caption =
      "The list laid onto the map by the answer, accepted or not. Colours by truth, which the "
      "matcher does not see.";
  exhibit.T_map_sensor = result.T_map_local;
  exhibit.range_m = one->detector.range_m;
  exhibit.map_m =
      around(world.mapped->map_m, result.T_map_local.translation_m, 2.0 * one->detector.range_m);
  for (std::size_t k = 0; k < query.list.trees.size(); ++k) {
    const Eigen::Vector2d place_m = result.T_map_local * query.list.stems_in_sensor_m[k];
    const std::int32_t tree = query.list.trees[k];
    const bool of_map =
        !world.other && tree >= 0 && world.mapped->in_map[static_cast<std::size_t>(tree)] != 0;
    (of_map ? exhibit.list_in_map_m : exhibit.felled_or_false_in_map_m).push_back(place_m);
  }
  return exhibit;
}

bool any_bound(const std::vector<SightingSummary>& summaries) {
  return std::any_of(summaries.begin(), summaries.end(), [](const SightingSummary& s) {
    return s.error_over_bound && s.successes >= 10;
  });
}

bool sizes_differ(const std::vector<SightingSummary>& summaries) {
  return std::any_of(summaries.begin(), summaries.end(), [&](const SightingSummary& s) {
    return s.stems_in_map > 2 * summaries.front().stems_in_map;
  });
}

}  // namespace

std::vector<ReportFigure> draw_sighting_figures(const std::filesystem::path& folder,
                                                const Scenario& scenario,
                                                const std::vector<SightingCase>& cases,
                                                const std::vector<SightingSummary>& summaries,
                                                const Table& lists) {
  std::vector<ReportFigure> figures;
  if (!scenario.sighting.elsewhere) {
    figures.push_back(draw_success_by_case(folder, summaries));
    if (any_bound(summaries)) figures.push_back(draw_bound_by_case(folder, summaries));
  }
  figures.push_back(sizes_differ(summaries) ? draw_time_by_size(folder, summaries)
                                            : draw_time_by_case(folder, summaries));
  for (const bool accepted : {true, false}) {
    const auto row = first_row(lists, accepted);
    if (!row || lists.ints("stems")[*row] == 0) continue;
    SightingExhibit exhibit = exhibit_of(scenario, cases, lists, *row);
    exhibit.name = accepted ? "example_accepted" : "example_refused";
    figures.push_back(draw_sighting_exhibit(folder, exhibit));
  }
  return figures;
}

}  // namespace honka::eval
