#pragma once

#include <cstdint>
#include <vector>

#include "algo/slam/exchange/cloud_receiver.h"
#include "eval/run/slam/link_cases.h"

namespace honka::eval {

/// What became of a drive's key frames on their way to the cloud.
struct LinkTally {
  EdgeTally edge;
  std::int64_t queue_full = 0, too_large = 0, lost_on_air = 0;
  std::int64_t arrived = 0;                 ///< until the drive's end
  std::int64_t late = 0;                    ///< arrived after it
  double bytes_on_air = 0.0;                ///< overhead included
  double age_p50_s = 0.0, age_p95_s = 0.0;  ///< of those that arrived, when they did; NaN for none
  /// Way driven since the newest frame that had arrived by then, mean over the key frames.
  double behind_m = 0.0;
};

struct LinkOutcome {
  LinkTally tally;
  CloudReceiver cloud;  ///< what it had when the drive ended
};

/// Sends a drive's key frames with these edge poses over a link: each is offered to the edge's
/// sender at its time, its bytes go through the radio, and those that arrive until the last key
/// frame was taken are received in the order of their arrival.
[[nodiscard]] LinkOutcome exchange_drive(const SlamDrive& drive, const FramePoses& edge_T_first,
                                         const LinkCase& link, std::uint64_t seed);

}  // namespace honka::eval
