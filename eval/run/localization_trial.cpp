#include "eval/run/localization_trial.h"

#include <fmt/format.h>

#include "eval/run/progress.h"
#include "eval/run/trial_row.h"

namespace honka::eval {
namespace {

/// What one key frame yields: its scans, their points in the map frame, and where they fell.
struct MappedKeyFrame {
  std::vector<Sweep> scans;
  LocalCloud points_in_map;
  ScanStatistics statistics;
};

MappedKeyFrame map_key_frame(const TrialWorld& world, const Drive& drive, std::size_t key_frame,
                             const KeyFrameSettings& mapping) {
  MappedKeyFrame mapped;
  auto sweeps = cast_key_frame(*world.lidar, drive, key_frame);
  mapped.statistics.add(sweeps);
  mapped.scans = scans_of(std::move(sweeps));
  mapped.points_in_map = aggregate(posed(drive.key_frames[key_frame], mapped.scans),
                                   world.lidar->model(), mapping, Pose3::Identity());
  return mapped;
}

struct MappedRun {
  LocalCloud cloud;
  std::vector<std::vector<Sweep>> scans;  ///< kept where asked for
  ScanStatistics statistics;
};

/// Casts a drive's key frames into a map cloud, and keeps the scans if `keep_scans`. Rays are cast
/// in parallel while the map grows in the order of the drive.
MappedRun scan_run(const Scenario& scenario, const TrialWorld& world, const Drive& drive,
                   const std::string& what, int threads, bool keep_scans) {
  const std::size_t count = drive.key_frames.size();
  Progress progress(what, "key frames", static_cast<std::int64_t>(count));
  KeyFrameSettings mapping = scenario.frame;
  mapping.max_range_m = scenario.map.stems.max_range_m;
  CloudMap map(scenario.map.stems.voxel_m);
  MappedRun run;
#pragma omp parallel for ordered schedule(dynamic) num_threads(threads)
  for (std::size_t k = 0; k < count; ++k) {
    MappedKeyFrame mapped = map_key_frame(world, drive, k, mapping);
#pragma omp ordered
    {
      run.statistics.merge(mapped.statistics);
      map.add(mapped.points_in_map);
      if (keep_scans) run.scans.push_back(std::move(mapped.scans));
      progress.advance();
    }
  }
  run.cloud = map.cloud();
  return run;
}

/// A trunk map that some variant asks for, before it is made.
struct MapOrder {
  std::string source;
  const LocalCloud* cloud = nullptr;
  StemSettings settings;
};

/// Every trunk map that a variant asks for, the default's first.
std::vector<TrunkMap> make_maps(const Scenario& scenario, const LocalCloud& prior_cloud,
                                const LocalCloud& work_cloud, std::int64_t trial, int threads) {
  StemSettings settings = scenario.map.stems;
  settings.voxel_m = 0.0;  // the clouds are thinned already
  const bool prior = scenario.map.source == "prior_run";
  const LocalCloud& cloud = prior ? prior_cloud : work_cloud;
  std::vector<MapOrder> orders = {{scenario.map.source, &cloud, settings}};
  if (scenario.variants.repaired) {
    orders.push_back({scenario.map.source, &cloud, repaired(settings, "circle_fit")});
  }
  if (scenario.variants.same_run && prior) orders.push_back({"same_run", &work_cloud, settings});

  Progress progress(fmt::format("stand {}: trunk maps", trial), "maps",
                    static_cast<std::int64_t>(orders.size()));
  std::vector<TrunkMap> maps(orders.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < orders.size(); ++i) {
    maps[i] = make_trunk_map(orders[i].source, *orders[i].cloud, orders[i].settings);
#pragma omp critical
    progress.advance();
  }
  return maps;
}

std::vector<LocalizationRow> localize_all(const Scenario& scenario, const TrialExhibit& exhibit,
                                          const StemMap& truth, std::int64_t trial, int threads) {
  const auto& windows = exhibit.windows;
  Progress progress(fmt::format("stand {}: localization", trial), "windows",
                    static_cast<std::int64_t>(windows.size()));
  std::vector<std::vector<LocalizationRow>> rows(windows.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t i = 0; i < windows.size(); ++i) {
    rows[i] =
        localize_window(windows[i], exhibit.scans, exhibit.variants, scenario, {&truth, trial});
#pragma omp critical
    progress.advance();
  }
  std::vector<LocalizationRow> all;
  for (auto& of_window : rows) all.insert(all.end(), of_window.begin(), of_window.end());
  return all;
}

}  // namespace

LocalizationTrial run_localization_trial(const Scenario& scenario, std::int64_t trial, int threads,
                                         bool with_exhibit) {
  auto exhibit = std::make_unique<TrialExhibit>();
  // World and drives
  exhibit->world = make_trial_world(scenario, trial);
  const TrialWorld& world = exhibit->world;
  const bool prior_run = scenario.map.source == "prior_run";
  exhibit->work = make_drive("work", world.work_path, scenario.harvester, scenario, world);
  if (prior_run) {
    exhibit->prior = make_drive("prior", world.prior_path, scenario.map.prior_run, scenario, world);
  }
  // Scans
  MappedRun prior = scan_run(scenario, world, exhibit->prior,
                             fmt::format("stand {}: prior run", trial), threads, false);
  MappedRun work = scan_run(scenario, world, exhibit->work,
                            fmt::format("stand {}: localized run", trial), threads, true);
  exhibit->scans = {&exhibit->work, &world.lidar->model(), std::move(work.scans)};
  // Maps and matchers
  exhibit->maps = make_maps(scenario, prior.cloud, work.cloud, trial, threads);
  exhibit->variants = make_variants(scenario, exhibit->maps);
  exhibit->map_cloud = std::move(prior_run ? prior.cloud : work.cloud);
  // Localization
  exhibit->windows = disjoint_windows(exhibit->work.key_frames.size(), scenario.protocol);
  const StemMap truth = true_stems(world.stand);
  const auto rows = localize_all(scenario, *exhibit, truth, trial, threads);

  LocalizationTrial result{trial_table(), localization_table(), work.statistics, nullptr};
  for (const LocalizationRow& row : rows) append(result.frames, row);
  append_trial(result.trials, trial, *exhibit, work.statistics, truth, scenario);
  if (with_exhibit) result.exhibit = std::move(exhibit);
  return result;
}

}  // namespace honka::eval
