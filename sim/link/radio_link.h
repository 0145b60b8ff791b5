#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/link/link_settings.h"

namespace honka::sim {

/// A message that the edge hands to its radio.
struct LinkMessage {
  std::uint64_t id = 0;    ///< its identity: loss and jitter are hashed from it; unique
  std::int64_t bytes = 0;  ///< payload; the link adds its own overhead
  double sent_s = 0.0;     ///< when it enters the edge's queue
};

enum class LinkFate : std::uint8_t {
  kDelivered,
  kQueueFull,  ///< dropped on the edge, as `queue_full` says which
  kTooLarge,   ///< would not fit into the empty queue
  kLostOnAir,  ///< took its time on the air and did not arrive
};

/// delivered | queue_full | too_large | lost_on_air
[[nodiscard]] const char* link_fate_name(LinkFate fate);

/// What became of a message.
struct LinkDelivery {
  std::uint64_t id = 0;
  LinkFate fate = LinkFate::kDelivered;
  std::int64_t bytes_on_air = 0;  ///< payload and overhead; 0 where it never left the queue
  double air_start_s = 0.0;       ///< first byte on the air; only where bytes_on_air > 0
  double air_end_s = 0.0;         ///< last byte on the air
  double received_s = 0.0;        ///< only where delivered
};

/// A radio link with a finite queue before it, bounded bandwidth, loss and delay. Messages go on
/// the air one at a time, first in first out; jitter may change the order in which they arrive.
/// Chance is a hash of (seed, id) and of (seed, time): the same messages meet the same fate, in
/// whatever order they are given.
class RadioLink {
 public:
  RadioLink(const LinkSettings& settings, std::uint64_t seed);

  /// Carries messages, in order of time sent (then id); returns one delivery a message, in the
  /// order given. Times must be finite and sizes not negative.
  [[nodiscard]] std::vector<LinkDelivery> carry(std::span<const LinkMessage> messages) const;

  /// Whether a message that leaves the air at this time is lost.
  [[nodiscard]] bool is_lost(std::uint64_t id, double air_end_s) const;

  /// Delay after the air: fixed part and jitter. Seconds.
  [[nodiscard]] double delay_s(std::uint64_t id) const;

 private:
  [[nodiscard]] bool in_bad_spell(double time_s) const;

  LinkSettings settings_;
  std::uint64_t seed_;
};

/// The deliveries that arrived until a time, in the order of arrival (then id).
[[nodiscard]] std::vector<LinkDelivery> arrived_until(std::span<const LinkDelivery> deliveries,
                                                      double time_s);

}  // namespace honka::sim
