#include "algo/slam/exchange/cloud_map.h"

namespace honka {

std::string_view cloud_map_status_name(CloudMapStatus status) {
  return status == CloudMapStatus::kMapped ? "mapped" : "nothing_received";
}

CloudMap map_received(const ReceivedFrames& received, const SlamSettings& settings) {
  CloudMap result;
  if (received.empty()) return result;
  result.map = run_slam(received.frames(), received.edge_T_first_frame(), settings);
  result.status = CloudMapStatus::kMapped;
  return result;
}

}  // namespace honka
