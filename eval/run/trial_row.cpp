#include "eval/run/trial_row.h"

#include <algorithm>
#include <limits>

#include "eval/metrics/trajectory_errors.h"
#include "eval/run/stem_judgement.h"

namespace honka::eval {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

struct TrueStems {
  StemMap when_mapped, now;
};

struct MapRow {
  double stems = kMissing, recall = kMissing, precision = kMissing, rmse_m = kMissing;
};

MapRow map_row(const TrialExhibit& exhibit, const std::string& source, bool is_repaired,
               const TrueStems& truth, const Scenario& scenario) {
  for (const TrunkMap& map : exhibit.maps) {
    if (map.source != source || map.repaired != is_repaired) continue;
    const Drive& run = source == "prior_run" ? exhibit.prior : exhibit.work;
    const StemMap& trees = source == "prior_run" ? truth.when_mapped : truth.now;
    const StemScores scores =
        score_map(map, trees, run, scenario.map.stems.max_range_m, scenario.protocol.stem_gate_m);
    return {static_cast<double>(map.stems.size()), scores.all.recall().value_or(kMissing),
            scores.all.precision().value_or(kMissing), scores.position_rmse_m.value_or(kMissing)};
  }
  return {};
}

struct OdometryRow {
  double ate_m = kMissing, unregistered = kMissing;
};

OdometryRow odometry_row(const Drive& drive) {
  if (drive.track.empty()) return {};
  PosePairs pairs;
  for (const KeyFrame& key_frame : drive.key_frames) {
    pairs.poses.push_back(
        {key_frame.time_s, key_frame.T_world_lidar, drive.T_world_odom * key_frame.T_odom_lidar});
  }
  const auto errors = trajectory_statistics(absolute_errors(pairs).translation_m);
  const auto unregistered = std::count_if(
      drive.track.estimates().begin(), drive.track.estimates().end(),
      [](const OdometryEstimate& e) { return e.status == OdometryStatus::kPredicted; });
  return {errors ? errors->rmse : kMissing, static_cast<double>(unregistered)};
}

void add_odometry_columns(Table& table, const std::string& prefix, const std::string& what) {
  const std::vector<double> none;
  table.add_column({prefix + "odometry_ate_m", "m",
                    "RMSE of key frame positions of " + what + ", laid onto the truth", none});
  table.add_column({prefix + "unregistered_sweeps", "",
                    "sweeps of " + what + " that the odometry could not register", none});
}

void add_map_columns(Table& table, const std::string& prefix, const std::string& what) {
  const std::vector<double> none;
  table.add_column({prefix + "_stems", "", "stems in " + what, none});
  table.add_column({prefix + "_recall", "", "share of the trees in reach that it holds", none});
  table.add_column({prefix + "_precision", "", "share of its stems that are trees", none});
  table.add_column({prefix + "_rmse_m", "m", "position error of its true stems", none});
}

}  // namespace

Table trial_table() {
  const std::vector<std::int64_t> integers;
  const std::vector<double> numbers;
  Table table({
      {"trial", "", "trial (stand)", integers},
      {"trees", "", "standing trees", integers},
      {"measured_trees", "", "of these, trees of a measured stem map", integers},
      {"key_frames", "", "key frames of the localized run", integers},
      {"windows", "", "disjoint windows", integers},
      {"prior_key_frames", "", "key frames of the prior run", integers},
      {"path_m", "m", "way of the localized run", numbers},
      {"duration_s", "s", "duration of the localized run", numbers},
      {"returns_share", "", "shots with a return", numbers},
      {"stem_share", "", "returns that fell on stems", numbers},
      {"hits_per_stem", "", "returns on a stem that was hit, a key frame", numbers},
      {"hits_0_10_m", "", "the same at 0-10 m", numbers},
      {"hits_10_20_m", "", "the same at 10-20 m", numbers},
      {"hits_20_30_m", "", "the same at 20-30 m", numbers},
      {"hits_30_47_m", "", "the same at 30-47 m", numbers},
  });
  add_odometry_columns(table, "", "the localized run");
  add_odometry_columns(table, "prior_", "the prior run");
  add_map_columns(table, "prior_map", "the map of the prior run");
  add_map_columns(table, "same_run_map", "the map of the localized run");
  add_map_columns(table, "repaired_map", "the map with height band and circle fits");
  return table;
}

void append_trial(Table& table, std::int64_t trial, const TrialExhibit& exhibit,
                  const Scenario& scenario) {
  const TrueStems truth = {true_stems(exhibit.world.when_mapped().stand),
                           true_stems(exhibit.world.stand)};
  const ScanStatistics& scans = exhibit.scan_statistics;
  const auto prior = map_row(exhibit, "prior_run", false, truth, scenario);
  const auto same = map_row(exhibit, "same_run", false, truth, scenario);
  const auto repaired = map_row(exhibit, scenario.map.source, true, truth, scenario);
  const Drive& work = exhibit.work;
  const OdometryRow of_work = odometry_row(work), of_prior = odometry_row(exhibit.prior);
  table.add_row(trial, exhibit.world.stand.trees.size(), exhibit.world.stand.measured_trees,
                work.key_frames.size(), exhibit.windows.size(), exhibit.prior.key_frames.size(),
                work.vehicle->travelled_m(work.vehicle->duration_s()), work.vehicle->duration_s(),
                static_cast<double>(scans.returns) / static_cast<double>(scans.shots),
                scans.share_on(sim::Part::kStem), scans.hits_per_stem(), scans.hits_per_stem(0),
                scans.hits_per_stem(1), scans.hits_per_stem(2), scans.hits_per_stem(3),
                of_work.ate_m, of_work.unregistered, of_prior.ate_m, of_prior.unregistered,
                prior.stems, prior.recall, prior.precision, prior.rmse_m, same.stems, same.recall,
                same.precision, same.rmse_m, repaired.stems, repaired.recall, repaired.precision,
                repaired.rmse_m);
}

}  // namespace honka::eval
