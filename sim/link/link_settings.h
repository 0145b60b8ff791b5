#pragma once

#include <cstdint>
#include <string>

#include "algo/types/settings.h"

namespace honka::sim {

/// A radio link from the machine to the cloud: datagrams, no retransmission.
struct LinkSettings {
  double bandwidth_bytes_per_s = 0.0;        ///< 0 is unbounded
  std::int64_t overhead_bytes = 28;          ///< of each message on the air: UDP over IPv4
  double loss = 0.0;                         ///< share of messages lost on the air, in [0, 1]
  std::string loss_pattern = "independent";  ///< independent | bursts (Gilbert and Elliott)
  double burst_s = 5.0;                      ///< mean length of a bad spell
  double burst_loss = 1.0;                   ///< share lost within one; not less than `loss`
  double delay_s = 0.05;                     ///< fixed part
  double jitter_s = 0.0;                     ///< on top, uniform in [0, jitter]
  std::int64_t queue_bytes = 65536;          ///< that the edge holds back; 0 is unbounded
  std::string queue_full = "drop_oldest";    ///< drop_oldest | drop_newest
};
void describe(SettingsVisitor& v, LinkSettings& s);

}  // namespace honka::sim
