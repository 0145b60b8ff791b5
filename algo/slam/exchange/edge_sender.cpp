#include "algo/slam/exchange/edge_sender.h"

#include <algorithm>

namespace honka {

void describe(SettingsVisitor& v, EdgeSettings& s) {
  v.field({"policy", "", "which key frames are sent: all, every k-th, or what the radio can carry",
           "choice"},
          s.policy, {"all", "every_kth", "paced"});
  v.field({"stride", "", "k of every_kth", "choice"}, s.stride, Range{1.0, 1e6});
  v.field({"longest_wait_s", "s", "that paced lets a message wait for the radio", "choice"},
          s.longest_wait_s, Range{0.0, 1e6});
}

EdgeSender::EdgeSender(const EdgeSettings& settings, const Uplink& uplink, std::uint8_t vehicle)
    : settings_(settings), uplink_(uplink), vehicle_(vehicle) {}

std::optional<EdgeMessage> EdgeSender::offer(const SparseFrame& frame, const Pose3& T_first_frame,
                                             double time_s) {
  EncodedFrame encoded = encode_frame({vehicle_, next_sequence_, frame, T_first_frame});
  const bool is_first = tally_.offered++ == 0;
  if (is_first) first_time_s_ = air_free_s_ = time_s;
  tally_.stems_not_finite += encoded.stems_not_finite;
  if (encoded.bytes.empty()) {
    ++tally_.not_encodable;
    return std::nullopt;
  }
  const auto payload = static_cast<std::int64_t>(encoded.bytes.size());
  tally_.stems_saturated += encoded.stems_saturated;
  tally_.bytes_offered += payload;
  if (!chooses(payload + uplink_.overhead_bytes, time_s)) {
    ++tally_.held_back;
    return std::nullopt;
  }
  ++tally_.sent;
  tally_.bytes_sent += payload;
  return EdgeMessage{frame.number, next_sequence_++, time_s, std::move(encoded.bytes)};
}

bool EdgeSender::chooses(std::int64_t bytes_on_air, double time_s) {
  if (settings_.policy == "all") return true;
  if (settings_.policy == "every_kth") return (tally_.offered - 1) % settings_.stride == 0;
  return paces(static_cast<double>(bytes_on_air), time_s);
}

bool EdgeSender::paces(double bytes_on_air, double time_s) {
  const double bandwidth = uplink_.bandwidth_bytes_per_s;
  if (bandwidth <= 0.0) return true;

  // 1. How much may wait: what the radio carries in the longest wait, as far as its queue holds.
  double may_wait = bandwidth * settings_.longest_wait_s;
  if (uplink_.queue_bytes > 0) {
    may_wait = std::min(may_wait, static_cast<double>(uplink_.queue_bytes));
  }
  // 2. The even part: what the radio could have carried so far of what there was to carry.
  need_bytes_ += bytes_on_air;
  const double could_carry = bandwidth * (time_s - first_time_s_) + may_wait;
  due_ = std::min(1.0, due_ + std::min(1.0, could_carry / need_bytes_));
  // 3. Send what is due where it finds room; an idle radio takes a message of any length.
  const double waits = std::max(0.0, (air_free_s_ - time_s) * bandwidth);
  const bool finds_room = waits <= 0.0 || waits + bytes_on_air <= may_wait;
  if (due_ < 1.0 || !finds_room) return false;
  due_ -= 1.0;
  air_free_s_ = std::max(air_free_s_, time_s) + bytes_on_air / bandwidth;
  return true;
}

}  // namespace honka
