#include "eval/run/localize/map_update_experiment.h"

#include <fmt/format.h>

#include <optional>

#include "algo/types/user_error.h"
#include "eval/run/localize/localize_results.h"
#include "eval/run/localize/map_update_figures.h"
#include "eval/run/localize/map_update_tables.h"
#include "eval/run/localize/timed_matcher.h"
#include "eval/run/progress.h"

namespace honka::eval {
namespace {

struct MapUpdateResults {
  std::vector<MapUpdateDrive> drives;
  std::optional<MapUpdateExhibit> exhibit;  ///< of the last thinning's first drive
};

MapUpdateDrive judged_drive(const Scenario& scenario, const MapUpdateWorld& world, MapUpdateRun run,
                            MapUpdateExhibit& exhibit) {
  // The picture shows the map that the last method named has fed: the one a user should use.
  const std::string shown = methods_of(scenario.variants.methods, scenario.localize).back();
  MapUpdateDrive drive;
  drive.felled_share = world.felled_share();
  drive.road = world.road;
  for (const MapSnapshot& snapshot : run.snapshots) {
    JudgedMap judged =
        judge_map(world, snapshot, scenario.map_update.updater, scenario.protocol.stem_gate_m);
    drive.maps.push_back(judged.quality);
    if (snapshot.fed_by != shown) continue;
    (snapshot.part == 0 ? exhibit.before : exhibit.after) = std::move(judged);
  }
  drive.answers = std::move(run.answers);
  return drive;
}

MapUpdateResults drive_all(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const auto [first, end] = trials_of(request);
  const auto& densities = scenario.map_update.thinned_to_per_ha;
  if (densities.empty()) {
    throw UserError("map_update.thinned_to_per_ha is empty; give at least one density, [156.0]");
  }
  MapUpdateResults results;
  std::optional<Progress> progress;
  for (const double density : densities) {
    for (std::int64_t trial = first; trial < end; ++trial) {
      const MapUpdateWorld world = make_map_update_world(scenario, trial, density);
      const auto lists = static_cast<std::int64_t>(world.T_world_sensor.size());
      if (!progress) {
        progress.emplace("map update", "lists",
                         lists * (end - first) * static_cast<std::int64_t>(densities.size()));
      }
      MapUpdateRun run = run_map_update(scenario, world, request.threads,
                                        [&](std::int64_t done) { progress->advance(done); });
      MapUpdateExhibit exhibit;
      exhibit.thinned_to_per_ha = density;
      results.drives.push_back(judged_drive(scenario, world, std::move(run), exhibit));
      results.drives.back().thinned_to_per_ha = density;
      results.drives.back().trial = trial;
      if (density == densities.back() && trial == first) results.exhibit = std::move(exhibit);
    }
  }
  return results;
}

}  // namespace

RunOutcome run_map_update_experiment(const RunRequest& request) {
  const Scenario& scenario = request.resolved.scenario;
  const Context context(request.threads, scenario.seed);
  OutputFolder folder(request.out);

  // Raw results
  const MapUpdateResults done = drive_all(request);

  // Metrics, figures, report
  const auto answers = summarize_answers(done.drives);
  const auto maps = summarize_maps(done.drives);
  LocalizeResults results;
  results.trials = map_quality_rows(done.drives);
  results.frames = map_update_answer_rows(done.drives);
  results.tables["map_update"] = map_update_json(answers, scenario);
  results.tables["map_quality"] = map_quality_json(maps, scenario);
  for (const MapUpdateSummary& s : answers) {
    if (s.part != 0) continue;
    results.metrics[fmt::format("success of {}, {}, {}/ha", s.method, s.map_name(),
                                s.thinned_to_per_ha)] =
        rate_metric(s.successes, s.queries, s.success_interval);
  }
  results.report_tables = {map_update_table(answers, scenario), map_quality_table(maps, scenario)};
  const auto figures = folder.path() / "figures";
  results.figures = {draw_map_before_after(figures, *done.exhibit)};
  for (ReportFigure& figure : draw_success_along_drive(figures, scenario, done.drives)) {
    results.figures.push_back(std::move(figure));
  }
  results.figures.push_back(draw_map_quality(figures, maps));
  results.notes = {
      "Matchers and updater see the map's stems and the listed stems alone; the updater hears the "
      "matcher's accepted poses, right or wrong. Trees and true poses enter the metrics only."};
  results.protocol = map_update_protocol(scenario);
  return write_localize_results(request, context, folder, std::move(results));
}

}  // namespace honka::eval
