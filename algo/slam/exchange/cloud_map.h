#pragma once

#include <cstdint>
#include <string_view>

#include "algo/slam/exchange/cloud_receiver.h"
#include "algo/slam/slam.h"

namespace honka {

enum class CloudMapStatus : std::uint8_t {
  kMapped,
  kNothingReceived,  ///< no frame arrived; there is no map
};
/// mapped | nothing_received
[[nodiscard]] std::string_view cloud_map_status_name(CloudMapStatus status);

/// What the cloud made of what arrived.
struct CloudMap {
  CloudMapStatus status = CloudMapStatus::kNothingReceived;
  SlamResult map;  ///< poses counted from the first frame that arrived
};

/// The cloud's map of what it received, by any method of `run_slam`, from the edge's poses. It
/// takes nothing else: what did not arrive cannot matter. UserError at an unknown method.
[[nodiscard]] CloudMap map_received(const ReceivedFrames& received, const SlamSettings& settings);

}  // namespace honka
