#include "eval/run/localize/sighting_experiment.h"

#include <fmt/format.h>

#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/sighting_figures.h"
#include "eval/run/localize/sighting_tables.h"
#include "eval/run/localize/sighting_trial.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/progress.h"

namespace honka::eval {
namespace {

struct SightingResults {
  Table maps = sighting_map_table();
  Table lists = sighting_table();
};

std::int64_t queries_in_all(const Scenario& scenario, const std::vector<SightingCase>& cases) {
  std::int64_t queries = 0;
  for (const SightingCase& one : cases) {
    for (const auto& method : methods_of(scenario.variants.methods, scenario.localize)) {
      queries += queries_of(one, method);
    }
  }
  return queries;
}

SightingResults run_cases(const RunRequest& request, const std::vector<SightingCase>& cases) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  Progress progress("localization of stem lists", "lists",
                    queries_in_all(scenario, cases) * (end - first) / scenario.trials);
  SightingResults results;
  for (const SightingCase& one : cases) {
    for (std::int64_t trial = first; trial < end; ++trial) {
      const SightingTrial done =
          run_sighting_trial(scenario, one, trial, request.threads, [&] { progress.advance(); });
      for (const SightingMapRow& row : done.maps) append(results.maps, row);
      for (const SightingRow& row : done.rows) append(results.lists, row);
    }
  }
  return results;
}

}  // namespace

RunOutcome run_sighting_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  const std::vector<SightingCase> cases = sighting_cases(scenario.sighting);
  OutputFolder folder(request.out);

  // Raw results
  auto [maps, lists] = run_cases(request, cases);

  // Metrics, figures, report
  const auto summaries = summarize_sightings(maps, lists);
  LocalizeResults results;
  results.figures =
      draw_sighting_figures(folder.path() / "figures", scenario, cases, summaries, lists);
  results.trials = std::move(maps);
  results.frames = std::move(lists);
  results.tables[table_name_of(request.resolved)] = sighting_json(summaries, scenario);
  for (const SightingSummary& s : summaries) {
    results.metrics[fmt::format("success of {}, {}", s.method, s.name)] =
        rate_metric(s.successes, s.queries, s.success_interval);
  }
  results.report_tables = {sighting_report_table(summaries, scenario, "Found, refused and wrong"),
                           sighting_cost_table(summaries)};
  results.notes = {
      "Matchers see the map's stems and the listed stems alone. Trees, poses and which stem is "
      "which enter the metrics only."};
  results.protocol = sighting_protocol(scenario);
  return write_localize_results(request, context, folder, std::move(results));
}

}  // namespace honka::eval
