#include "eval/run/mapped_run.h"

#include "eval/run/localize/source_map.h"

namespace honka::eval {

MappedRun map_run(const DriveOrder& order, const Scenario& scenario, std::uint64_t seed,
                  const std::string& what, int threads, bool keep_scans) {
  KeyFrameSettings mapping = scenario.frame;
  mapping.max_range_m = scenario.map.stems.max_range_m;
  CloudMap map(scenario.map.stems.voxel_m);
  MappedRun run;
  const auto gather = [&](const KeyFrame& key_frame, std::vector<sim::TruthfulSweep>&& sweeps) {
    run.statistics.add(sweeps);
    std::vector<Sweep> scans = scans_of(std::move(sweeps));
    map.add(aggregate(posed(key_frame, scans), order.stand->lidar->model(), mapping,
                      Pose3::Identity()));
    if (keep_scans) run.scans.push_back(std::move(scans));
  };
  run.drive = drive_and_scan(order, scenario, seed, what, threads, gather);
  run.cloud_in_odom = map.cloud();
  return run;
}

TrunkMap trunk_map_of(const std::string& source, const MappedRun& run, const StemSettings& settings,
                      const Scenario& scenario, const TrialWorld& world) {
  if (lists_trees(source)) {
    return listed_trunk_map(scenario, world.when_mapped().stand, settings, world.seed);
  }
  return make_trunk_map(source, run.cloud_in_odom, settings, planar(run.drive.T_world_odom));
}

StemSettings stems_of_thinned_cloud(const Scenario& scenario) {
  StemSettings settings = scenario.map.stems;
  settings.voxel_m = 0.0;
  return settings;
}

}  // namespace honka::eval
