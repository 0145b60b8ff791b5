#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algo/slam/exchange/frame_message.h"
#include "algo/types/settings.h"

namespace honka {

/// Which key frames the edge sends.
struct EdgeSettings {
  std::string policy = "paced";  ///< all | every_kth | paced
  std::int64_t stride = 1;       ///< k of every_kth
  double longest_wait_s = 30.0;  ///< of a message for the radio, by `paced`
};
void describe(SettingsVisitor& v, EdgeSettings& s);

/// What the edge knows of its radio.
struct Uplink {
  double bandwidth_bytes_per_s = 0.0;  ///< 0 is unbounded
  std::int64_t queue_bytes = 0;        ///< 0 is unbounded
  std::int64_t overhead_bytes = 0;     ///< of each message
};

/// A message for the radio.
struct EdgeMessage {
  std::int64_t frame_number = 0;
  std::uint32_t sequence = 0;
  double time_s = 0.0;  ///< when the key frame was taken
  std::vector<std::uint8_t> bytes;
};

/// What the edge did with the key frames offered to it.
struct EdgeTally {
  std::int64_t offered = 0, sent = 0, held_back = 0, not_encodable = 0;
  std::int64_t stems_not_finite = 0, stems_saturated = 0;
  std::int64_t bytes_offered = 0;  ///< payload of all frames offered: the need
  std::int64_t bytes_sent = 0;     ///< payload of those sent
};

/// The edge's side of the exchange: chooses the key frames that its radio can carry and makes
/// messages of them. `paced` sends an even part of the key frames, as large as what the radio could
/// have carried over what there was to carry so far, and holds a frame back where it would wait too
/// long or the queue could not take it. So the queue never overflows, and what is missing is spread
/// evenly over the drive.
class EdgeSender {
 public:
  EdgeSender(const EdgeSettings& settings, const Uplink& uplink, std::uint8_t vehicle = 0);

  /// Offers the next key frame, its edge pose and the time at which it was taken (not falling).
  /// Nothing where the frame is held back or cannot be encoded.
  [[nodiscard]] std::optional<EdgeMessage> offer(const SparseFrame& frame,
                                                 const Pose3& T_first_frame, double time_s);

  [[nodiscard]] const EdgeTally& tally() const { return tally_; }

 private:
  [[nodiscard]] bool chooses(std::int64_t bytes_on_air, double time_s);
  [[nodiscard]] bool paces(double bytes_on_air, double time_s);

  EdgeSettings settings_;
  Uplink uplink_;
  std::uint8_t vehicle_;
  EdgeTally tally_;
  double first_time_s_ = 0.0;
  double air_free_s_ = 0.0;  ///< when the radio will have sent all that it was given
  double due_ = 1.0;         ///< frames that the even part owes; the first one always
  double need_bytes_ = 0.0;  ///< on the air, of all frames offered
  std::uint32_t next_sequence_ = 0;
};

}  // namespace honka
