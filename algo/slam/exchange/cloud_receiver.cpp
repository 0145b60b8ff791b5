#include "algo/slam/exchange/cloud_receiver.h"

#include <algorithm>
#include <utility>

namespace honka {

std::string_view receive_status_name(ReceiveStatus status) {
  switch (status) {
    case ReceiveStatus::kNew:
      return "new";
    case ReceiveStatus::kDuplicate:
      return "duplicate";
    case ReceiveStatus::kOtherVehicle:
      return "other_vehicle";
    case ReceiveStatus::kRefused:
      return "refused";
  }
  return "";
}

ReceiveStatus CloudReceiver::receive(std::span<const std::uint8_t> bytes) {
  ++tally_.messages;
  DecodedFrame decoded = decode_frame(bytes);
  if (decoded.status != DecodeStatus::kDecoded) {
    ++tally_.refused;
    ++tally_.refused_by_status[static_cast<std::size_t>(decoded.status)];
    return ReceiveStatus::kRefused;
  }
  if (decoded.message.vehicle != vehicle_) {
    ++tally_.other_vehicle;
    return ReceiveStatus::kOtherVehicle;
  }
  const std::int64_t number = decoded.message.frame.number;
  if (!by_number_.try_emplace(number, std::move(decoded.message)).second) {
    ++tally_.duplicates;
    return ReceiveStatus::kDuplicate;
  }
  return ReceiveStatus::kNew;
}

ReceivedFrames CloudReceiver::received() const {
  ReceivedFrames result;
  if (by_number_.empty()) return result;
  const Pose3 T_first_edge = by_number_.begin()->second.T_first_frame.inverse();
  for (const auto& [number, message] : by_number_) {
    if (!result.frames_.empty() && result.frames_.back().number + 1 != number) {
      result.gaps_.push_back({result.frames_.back().number, number});
    }
    result.frames_.push_back(message.frame);
    result.edge_T_first_frame_.push_back(T_first_edge * message.T_first_frame);
  }
  result.edge_T_first_frame_.front() = Pose3::Identity();
  return result;
}

CloudTally CloudReceiver::tally() const {
  CloudTally tally = tally_;
  tally.frames = static_cast<std::int64_t>(by_number_.size());
  std::int64_t messages_known = 0;
  for (const auto& [number, message] : by_number_) {
    messages_known = std::max(messages_known, std::int64_t{message.sequence} + 1);
  }
  tally.lost_messages = std::max<std::int64_t>(0, messages_known - tally.frames);
  return tally;
}

}  // namespace honka
