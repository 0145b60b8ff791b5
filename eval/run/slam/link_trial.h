#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "eval/config/scenario.h"
#include "eval/run/slam/link_exchange.h"
#include "eval/run/slam/link_quality.h"

namespace honka::eval {

/// A link, what came through it, and the map that one method made of that.
struct LinkRow {
  std::int64_t trial = 0;
  LinkCase link;
  std::string method;
  std::string status;  ///< cloud_map_status_name
  LinkTally tally;
  LinkMapQuality quality;
  LinkMapQuality floor;   ///< of the frames that arrived, at their true poses
  double length_m = 0.0;  ///< of the drive
  double map_s = 0.0;     ///< that the method took

  [[nodiscard]] double sent_bytes_per_m() const {
    return static_cast<double>(tally.edge.bytes_sent) / length_m;
  }
};

/// The poses that a drive's messages carry: link.study.edge_poses.
[[nodiscard]] FramePoses edge_poses_of(const SlamDrive& drive, const Scenario& scenario);

/// How good the map of these frames of a drive would be at their true poses.
[[nodiscard]] LinkMapQuality link_floor(const SlamDrive& drive, std::span<const SparseFrame> frames,
                                        const SlamSettings& settings);

/// Names the chances of the links of a trial.
[[nodiscard]] std::uint64_t link_seed(const Scenario& scenario, std::int64_t trial);

/// Maps what came through by the method of `row`, and judges it: status, quality and time of `row`.
void map_over_link(const SlamDrive& drive, const ReceivedFrames& received, SlamSettings settings,
                   LinkRow& row);

struct LinkTrial {
  LinkNeed need;
  std::vector<LinkRow> rows;  ///< by link, then by method
};

/// Sends one drive over every link of the scenario and maps what arrives by every method. `trial`
/// names the chances of the links. The digits do not depend on the threads.
[[nodiscard]] LinkTrial study_links(const SlamDrive& drive, const Scenario& scenario,
                                    std::int64_t trial, int threads);

}  // namespace honka::eval
