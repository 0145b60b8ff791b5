#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "sim/link/radio_link.h"

namespace honka::sim {

/// The queue before the radio: first in first out, one message on the air at a time. Writes when
/// each message was on the air, or why it never was.
class EdgeQueue {
 public:
  /// `deliveries` outlives the queue and holds one place a message.
  EdgeQueue(const LinkSettings& settings, std::vector<LinkDelivery>& deliveries);

  /// Takes the message whose place in the deliveries is `index`; times do not fall.
  void take(std::size_t index, const LinkMessage& message);

  /// Puts all that still waits on the air.
  void drain();

 private:
  struct Waiting {
    std::size_t index = 0;
    std::int64_t bytes = 0;
    double sent_s = 0.0;
  };
  /// Whether the message finds room; the full queue drops as `queue_full` says.
  [[nodiscard]] bool makes_room_for(std::int64_t bytes);
  /// Puts on the air what starts until this time.
  void send_until(double time_s);
  void drop_front();

  const LinkSettings& settings_;
  std::vector<LinkDelivery>& deliveries_;
  std::deque<Waiting> waiting_;
  std::int64_t waiting_bytes_ = 0;
  double air_free_s_;
};

}  // namespace honka::sim
