#pragma once

#include <string>
#include <vector>

#include "algo/slam/exchange/edge_sender.h"
#include "eval/config/link_study_settings.h"
#include "eval/run/slam/slam_drive.h"

namespace honka::eval {

/// What a drive's key frames take when all of them are sent, beside the sensor's raw packets.
struct LinkNeed {
  std::int64_t key_frames = 0, stems = 0;
  double duration_s = 0.0, length_m = 0.0;
  double message_bytes = 0.0;  ///< payload of all key frames
  double air_bytes = 0.0;      ///< with the network's overhead
  double raw_bytes = 0.0;      ///< 1206-byte packets of the lidar

  [[nodiscard]] double bytes_per_s() const { return air_bytes / duration_s; }
};

/// The need of a drive. `firing_period_s` of the lidar gives the packets: 24 firings each.
[[nodiscard]] LinkNeed need_of(const SlamDrive& drive, std::int64_t overhead_bytes,
                               double firing_period_s);

/// One link of the study.
struct LinkCase {
  std::string series;   ///< bandwidth | loss | delay
  std::string variant;  ///< of the edge's policy or of the loss's pattern
  double value = 0.0;   ///< share of the need, share lost, seconds
  sim::LinkSettings radio;
  EdgeSettings edge;
};

/// Every link of the study: each series changes one thing about `settings.radio`. Bandwidths are
/// shares of the need, with the edge's policy, and with every frame given to a queue that drops the
/// oldest or the newest; losses are independent, and in bursts.
[[nodiscard]] std::vector<LinkCase> link_cases(const LinkStudySettings& settings,
                                               const LinkNeed& need);

}  // namespace honka::eval
