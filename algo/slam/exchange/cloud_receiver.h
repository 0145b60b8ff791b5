#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "algo/slam/exchange/frame_message.h"

namespace honka {

/// Frame numbers that did not arrive between two that did.
struct FrameGap {
  std::int64_t after = 0, before = 0;  ///< numbers of the frames at its ends
  [[nodiscard]] std::int64_t missing() const { return before - after - 1; }
};

/// What the cloud has of a drive: all that its methods may use. Only a CloudReceiver makes one, so
/// a method that takes ReceivedFrames cannot have seen a frame that did not arrive.
class ReceivedFrames {
 public:
  /// In order of frame number, each once.
  [[nodiscard]] const std::vector<SparseFrame>& frames() const { return frames_; }
  /// The edge's poses of these frames, counted from the first that arrived (the identity).
  [[nodiscard]] const FramePoses& edge_T_first_frame() const { return edge_T_first_frame_; }
  [[nodiscard]] const std::vector<FrameGap>& gaps() const { return gaps_; }
  [[nodiscard]] bool empty() const { return frames_.empty(); }

 private:
  friend class CloudReceiver;
  ReceivedFrames() = default;

  std::vector<SparseFrame> frames_;
  FramePoses edge_T_first_frame_;
  std::vector<FrameGap> gaps_;
};

enum class ReceiveStatus : std::uint8_t {
  kNew,
  kDuplicate,     ///< this frame number is known; the first one stays
  kOtherVehicle,  ///< not this receiver's
  kRefused,       ///< the bytes do not decode
};
[[nodiscard]] std::string_view receive_status_name(ReceiveStatus status);

/// What arrived, and what is known to be missing.
struct CloudTally {
  std::int64_t messages = 0, frames = 0, duplicates = 0, other_vehicle = 0, refused = 0;
  std::array<std::int64_t, 6> refused_by_status{};  ///< by DecodeStatus
  std::int64_t lost_messages = 0;  ///< missing sequence numbers below the highest one
};

/// The cloud's side of the exchange: gathers frames from whatever arrives, in whatever order.
class CloudReceiver {
 public:
  explicit CloudReceiver(std::uint8_t vehicle = 0) : vehicle_(vehicle) {}

  /// Takes any bytes; damaged ones are refused and counted.
  ReceiveStatus receive(std::span<const std::uint8_t> bytes);

  [[nodiscard]] ReceivedFrames received() const;
  [[nodiscard]] CloudTally tally() const;

 private:
  std::uint8_t vehicle_;
  std::map<std::int64_t, FrameMessage> by_number_;
  CloudTally tally_;
};

}  // namespace honka
