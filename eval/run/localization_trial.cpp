#include "eval/run/localization_trial.h"

#include <fmt/format.h>

#include "eval/run/mapped_run.h"
#include "eval/run/parallel.h"
#include "eval/run/progress.h"
#include "eval/run/trial_row.h"

namespace honka::eval {
namespace {

/// A trunk map that some variant asks for, before it is made.
struct MapOrder {
  std::string source;
  const MappedRun* run = nullptr;
  StemSettings settings;
};

/// Every trunk map that a variant asks for, the default's first.
std::vector<TrunkMap> make_maps(const Scenario& scenario, const TrialWorld& world,
                                const MappedRun& prior_run, const MappedRun& work_run,
                                std::int64_t trial, int threads) {
  const StemSettings settings = stems_of_thinned_cloud(scenario);
  const bool prior = scenario.map.source == "prior_run";
  const MappedRun& run = prior ? prior_run : work_run;
  std::vector<MapOrder> orders = {{scenario.map.source, &run, settings}};
  if (scenario.variants.repaired) {
    orders.push_back({scenario.map.source, &run, repaired(settings, "circle_fit")});
  }
  if (scenario.variants.same_run && scenario.map.source != "same_run") {
    orders.push_back({"same_run", &work_run, settings});
  }

  Progress progress(fmt::format("stand {}: trunk maps", trial), "maps",
                    static_cast<std::int64_t>(orders.size()));
  std::vector<TrunkMap> maps(orders.size());
  for_each_index(orders.size(), threads, [&](std::size_t i) {
    maps[i] = trunk_map_of(orders[i].source, *orders[i].run, orders[i].settings, scenario, world);
    progress.advance();
  });
  return maps;
}

/// Hands the runs over; the map's cloud is laid onto the world.
void keep_for_figures(TrialExhibit& exhibit, MappedRun prior, MappedRun work) {
  const bool by_prior = prior.drive.vehicle != nullptr;
  exhibit.map_cloud = std::move(by_prior ? prior.cloud_in_odom : work.cloud_in_odom);
  const Pose3 T_world_odom = (by_prior ? prior : work).drive.T_world_odom;
  for (Eigen::Vector3d& point : exhibit.map_cloud.points_m) point = T_world_odom * point;
  exhibit.scan_statistics = work.statistics;
  exhibit.prior = std::move(prior.drive);
  exhibit.work = std::move(work.drive);
  exhibit.scans = {&exhibit.work, &exhibit.world.lidar->model(), std::move(work.scans)};
}

std::vector<LocalizationRow> localize_all(const Scenario& scenario, const TrialExhibit& exhibit,
                                          const StemMap& truth, std::int64_t trial, int threads) {
  const auto& windows = exhibit.windows;
  Progress progress(fmt::format("stand {}: localization", trial), "windows",
                    static_cast<std::int64_t>(windows.size()));
  std::vector<std::vector<LocalizationRow>> rows(windows.size());
  for_each_index(windows.size(), threads, [&](std::size_t i) {
    rows[i] =
        localize_window(windows[i], exhibit.scans, exhibit.variants, scenario, {&truth, trial});
    progress.advance();
  });
  std::vector<LocalizationRow> all;
  for (auto& of_window : rows) all.insert(all.end(), of_window.begin(), of_window.end());
  return all;
}

/// Of truth and noise there is nothing to judge.
std::vector<RunTrack> tracks_of(const TrialExhibit& exhibit, const Scenario& scenario) {
  std::vector<RunTrack> tracks;
  if (scenario.odometry.source == "truth+noise") return tracks;
  if (exhibit.prior.vehicle) tracks.push_back(track_of_run("prior", exhibit.prior));
  tracks.push_back(track_of_run("work", exhibit.work));
  return tracks;
}

}  // namespace

LocalizationTrial run_localization_trial(const Scenario& scenario, std::int64_t trial, int threads,
                                         bool with_exhibit) {
  auto exhibit = std::make_unique<TrialExhibit>();
  // World
  exhibit->world = make_trial_world(scenario, trial);
  const TrialWorld& world = exhibit->world;
  // Runs
  const std::string stand = fmt::format("stand {}: ", trial);
  MappedRun prior;
  if (scenario.map.source == "prior_run") {
    prior = map_run(prior_drive(scenario, world), scenario, world.seed, stand + "prior run",
                    threads, false);
  }
  MappedRun work = map_run(work_drive(scenario, world), scenario, world.seed,
                           stand + "localized run", threads, true);
  // Maps and matchers
  exhibit->maps = make_maps(scenario, world, prior, work, trial, threads);
  exhibit->variants = make_variants(scenario, exhibit->maps);
  keep_for_figures(*exhibit, std::move(prior), std::move(work));
  // Localization
  exhibit->windows = disjoint_windows(exhibit->work.key_frames.size(), scenario.protocol);
  const StemMap truth = true_stems(world.stand);
  const auto rows = localize_all(scenario, *exhibit, truth, trial, threads);

  LocalizationTrial result{trial_table(), localization_table(), {}, nullptr};
  for (const LocalizationRow& row : rows) append(result.frames, row);
  append_trial(result.trials, trial, *exhibit, scenario);
  result.tracks = tracks_of(*exhibit, scenario);
  if (with_exhibit) result.exhibit = std::move(exhibit);
  return result;
}

}  // namespace honka::eval
