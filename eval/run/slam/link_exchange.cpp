#include "eval/run/slam/link_exchange.h"

#include <algorithm>
#include <limits>

#include "eval/metrics/statistics.h"
#include "sim/link/radio_link.h"

namespace honka::eval {
namespace {

constexpr double kNoAge = std::numeric_limits<double>::quiet_NaN();

std::vector<EdgeMessage> messages_of(const SlamDrive& drive, const FramePoses& edge_T_first,
                                     const LinkCase& link, EdgeTally& tally) {
  const sim::LinkSettings& radio = link.radio;
  EdgeSender sender(link.edge,
                    {radio.bandwidth_bytes_per_s, radio.queue_bytes, radio.overhead_bytes});
  std::vector<EdgeMessage> messages;
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    auto message = sender.offer(drive.frames[i], edge_T_first[i], drive.times_s[i]);
    if (message) messages.push_back(std::move(*message));
  }
  tally = sender.tally();
  return messages;
}

void count_fates(const std::vector<sim::LinkDelivery>& deliveries, double end_s, LinkTally& tally) {
  for (const sim::LinkDelivery& delivery : deliveries) {
    tally.bytes_on_air += static_cast<double>(delivery.bytes_on_air);
    switch (delivery.fate) {
      case sim::LinkFate::kQueueFull:
        ++tally.queue_full;
        break;
      case sim::LinkFate::kTooLarge:
        ++tally.too_large;
        break;
      case sim::LinkFate::kLostOnAir:
        ++tally.lost_on_air;
        break;
      case sim::LinkFate::kDelivered:
        ++(delivery.received_s > end_s ? tally.late : tally.arrived);
        break;
    }
  }
}

/// Mean over the key frames of the way driven since the newest frame that had arrived by then.
/// `arrived` in the order of arrival; ids are indices of messages.
double mean_way_behind(const SlamDrive& drive, const std::vector<EdgeMessage>& messages,
                       const std::vector<sim::LinkDelivery>& arrived) {
  double sum_m = 0.0, newest_m = drive.travelled_m.front();
  std::size_t next = 0;
  for (std::size_t i = 0; i < drive.frames.size(); ++i) {
    for (; next < arrived.size() && arrived[next].received_s <= drive.times_s[i]; ++next) {
      const EdgeMessage& message = messages[static_cast<std::size_t>(arrived[next].id)];
      newest_m =
          std::max(newest_m, drive.travelled_m[static_cast<std::size_t>(message.frame_number)]);
    }
    sum_m += drive.travelled_m[i] - newest_m;
  }
  return sum_m / static_cast<double>(drive.frames.size());
}

}  // namespace

LinkOutcome exchange_drive(const SlamDrive& drive, const FramePoses& edge_T_first,
                           const LinkCase& link, std::uint64_t seed) {
  LinkOutcome outcome;
  if (drive.frames.empty()) return outcome;

  // 1. The edge chooses and encodes.
  const auto messages = messages_of(drive, edge_T_first, link, outcome.tally.edge);

  // 2. The radio carries; loss and jitter hang on the frame's number.
  std::vector<sim::LinkMessage> on_radio;
  for (const EdgeMessage& message : messages) {
    on_radio.push_back({static_cast<std::uint64_t>(message.frame_number),
                        static_cast<std::int64_t>(message.bytes.size()), message.time_s});
  }
  auto deliveries = sim::RadioLink(link.radio, seed).carry(on_radio);
  for (std::size_t i = 0; i < deliveries.size(); ++i) deliveries[i].id = i;
  const double end_s = drive.times_s.back();
  count_fates(deliveries, end_s, outcome.tally);

  // 3. The cloud receives what arrives until the drive's end.
  const auto arrived = sim::arrived_until(deliveries, end_s);
  std::vector<double> ages_s;
  for (const sim::LinkDelivery& delivery : arrived) {
    const EdgeMessage& message = messages[static_cast<std::size_t>(delivery.id)];
    ages_s.push_back(delivery.received_s - message.time_s);
    outcome.cloud.receive(message.bytes);
  }
  outcome.tally.age_p50_s = percentile(ages_s, 50).value_or(kNoAge);
  outcome.tally.age_p95_s = percentile(ages_s, 95).value_or(kNoAge);
  outcome.tally.behind_m = mean_way_behind(drive, messages, arrived);
  return outcome;
}

}  // namespace honka::eval
