#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "eval/run/drive.h"
#include "eval/run/scan_statistics.h"
#include "eval/run/trunk_map.h"

namespace honka::eval {

/// A run as the machine that drove it remembers it.
struct MappedRun {
  Drive drive;
  LocalCloud cloud_in_odom;               ///< of every key frame, thinned
  std::vector<std::vector<Sweep>> scans;  ///< one entry a key frame, where asked for
  ScanStatistics statistics;
};

/// Drives, and gathers a map cloud while the sweeps come; keeps the scans if `keep_scans`. `what`
/// leads the line of progress, and none is shown where it is empty.
[[nodiscard]] MappedRun map_run(const DriveOrder& order, const Scenario& scenario,
                                std::uint64_t seed, const std::string& what, int threads,
                                bool keep_scans);

/// The trunk map that a run made, or, of a map source that lists trees, the list of the stand as
/// it was mapped; `run` is then not looked at.
[[nodiscard]] TrunkMap trunk_map_of(const std::string& source, const MappedRun& run,
                                    const StemSettings& settings, const Scenario& scenario,
                                    const TrialWorld& world);

/// scenario.map.stems for clouds that are thinned already.
[[nodiscard]] StemSettings stems_of_thinned_cloud(const Scenario& scenario);

}  // namespace honka::eval
