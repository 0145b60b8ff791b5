#include "sim/link/edge_queue.h"

#include <algorithm>
#include <limits>

namespace honka::sim {

EdgeQueue::EdgeQueue(const LinkSettings& settings, std::vector<LinkDelivery>& deliveries)
    : settings_(settings),
      deliveries_(deliveries),
      air_free_s_(-std::numeric_limits<double>::infinity()) {}

void EdgeQueue::take(std::size_t index, const LinkMessage& message) {
  const std::int64_t bytes = message.bytes + settings_.overhead_bytes;
  LinkDelivery& delivery = deliveries_[index];
  delivery.id = message.id;
  if (settings_.queue_bytes > 0 && bytes > settings_.queue_bytes) {
    delivery.fate = LinkFate::kTooLarge;
    return;
  }
  send_until(message.sent_s);
  if (!makes_room_for(bytes)) {
    delivery.fate = LinkFate::kQueueFull;
    return;
  }
  waiting_.push_back({index, bytes, message.sent_s});
  waiting_bytes_ += bytes;
  send_until(message.sent_s);
}

void EdgeQueue::drain() { send_until(std::numeric_limits<double>::infinity()); }

bool EdgeQueue::makes_room_for(std::int64_t bytes) {
  const auto is_full = [&] {
    return settings_.queue_bytes > 0 && waiting_bytes_ + bytes > settings_.queue_bytes;
  };
  if (settings_.queue_full == "drop_newest") return !is_full();
  while (is_full()) {
    deliveries_[waiting_.front().index].fate = LinkFate::kQueueFull;
    drop_front();
  }
  return true;
}

void EdgeQueue::send_until(double time_s) {
  const double bandwidth = settings_.bandwidth_bytes_per_s;
  while (!waiting_.empty()) {
    const Waiting& next = waiting_.front();
    const double start_s = std::max(air_free_s_, next.sent_s);
    if (start_s > time_s) return;
    LinkDelivery& delivery = deliveries_[next.index];
    delivery.bytes_on_air = next.bytes;
    delivery.air_start_s = start_s;
    delivery.air_end_s =
        bandwidth > 0.0 ? start_s + static_cast<double>(next.bytes) / bandwidth : start_s;
    air_free_s_ = delivery.air_end_s;
    drop_front();
  }
}

void EdgeQueue::drop_front() {
  waiting_bytes_ -= waiting_.front().bytes;
  waiting_.pop_front();
}

}  // namespace honka::sim
