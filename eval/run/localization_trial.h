#pragma once

#include <cstdint>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/io/table.h"
#include "eval/run/run_tracks.h"
#include "eval/run/scan_statistics.h"
#include "eval/run/trunk_map.h"
#include "eval/run/windows.h"

namespace honka::eval {

/// What one trial leaves for the figures of the report; large, so kept for one trial only.
struct TrialExhibit {
  TrialWorld world;
  Drive prior, work;
  ScannedRun scans;
  ScanStatistics scan_statistics;  ///< of the localized run
  LocalCloud map_cloud;            ///< of the default map's run, laid onto the world
  std::vector<TrunkMap> maps;
  std::vector<Variant> variants;
  std::vector<Window> windows;
};

/// Rows of one trial: one for /trials, one a localization for /frames.
struct LocalizationTrial {
  Table trials, frames;
  std::vector<RunTrack> tracks;           ///< of a lidar odometry
  std::unique_ptr<TrialExhibit> exhibit;  ///< where it was asked for
};

/// One stand from rays to answers. The digits depend on (scenario, trial) alone, whatever the
/// threads.
[[nodiscard]] LocalizationTrial run_localization_trial(const Scenario& scenario, std::int64_t trial,
                                                       int threads, bool with_exhibit);

}  // namespace honka::eval
