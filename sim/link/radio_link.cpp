#include "sim/link/radio_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algo/types/check.h"
#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "sim/link/edge_queue.h"

namespace honka::sim {
namespace {

/// Steps that the mean bad spell is made of: its length is right to a twentieth.
constexpr double kStepsOfBadSpell = 10.0;

std::vector<std::size_t> order_of_sending(std::span<const LinkMessage> messages) {
  std::vector<std::size_t> order(messages.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(messages[a].sent_s, messages[a].id) <
           std::pair(messages[b].sent_s, messages[b].id);
  });
  return order;
}

void check_messages(std::span<const LinkMessage> messages) {
  for (const LinkMessage& message : messages) {
    HONKA_CHECK(std::isfinite(message.sent_s) && message.bytes >= 0,
                "a message has a time and a size");
  }
}

}  // namespace

const char* link_fate_name(LinkFate fate) {
  switch (fate) {
    case LinkFate::kDelivered:
      return "delivered";
    case LinkFate::kQueueFull:
      return "queue_full";
    case LinkFate::kTooLarge:
      return "too_large";
    case LinkFate::kLostOnAir:
      return "lost_on_air";
  }
  return "";
}

RadioLink::RadioLink(const LinkSettings& settings, std::uint64_t seed)
    : settings_(settings), seed_(seed) {
  if (settings.loss_pattern == "bursts" && settings.burst_loss < settings.loss) {
    throw UserError(fmt::format(
        "link.burst_loss = {}: bad spells that lose {} of their messages cannot make a loss of {}; "
        "set it to link.loss or more",
        settings.burst_loss, settings.burst_loss, settings.loss));
  }
}

std::vector<LinkDelivery> RadioLink::carry(std::span<const LinkMessage> messages) const {
  check_messages(messages);
  std::vector<LinkDelivery> deliveries(messages.size());
  EdgeQueue queue(settings_, deliveries);
  for (const std::size_t i : order_of_sending(messages)) queue.take(i, messages[i]);
  queue.drain();
  for (LinkDelivery& delivery : deliveries) {
    if (delivery.fate != LinkFate::kDelivered) continue;
    if (is_lost(delivery.id, delivery.air_end_s)) {
      delivery.fate = LinkFate::kLostOnAir;
    } else {
      delivery.received_s = delivery.air_end_s + delay_s(delivery.id);
    }
  }
  return deliveries;
}

bool RadioLink::is_lost(std::uint64_t id, double air_end_s) const {
  const double chance = RandomStream(seed_, "link_loss", {id}).uniform();
  if (settings_.loss_pattern == "independent") return chance < settings_.loss;
  return chance < settings_.burst_loss && in_bad_spell(air_end_s);
}

double RadioLink::delay_s(std::uint64_t id) const {
  const double chance = RandomStream(seed_, "link_jitter", {id}).uniform();
  return settings_.delay_s + settings_.jitter_s * chance;
}

/// The two-state chain of Gilbert and Elliott over steps of time, written so that any step can be
/// asked alone: at a step the state is kept, or with probability `renewal` drawn anew from its
/// long-run share. Going back to the last renewal gives the state; bad spells last
/// 1 / (renewal (1 − share)) steps on the average.
bool RadioLink::in_bad_spell(double time_s) const {
  const double share = settings_.loss / settings_.burst_loss;
  if (share <= 0.0 || share >= 1.0) return share >= 1.0;
  const double renewal = std::min(1.0, 1.0 / (kStepsOfBadSpell * (1.0 - share)));
  auto step = static_cast<std::int64_t>(std::floor(time_s * kStepsOfBadSpell / settings_.burst_s));
  while (true) {
    RandomStream stream(seed_, "link_spell", {static_cast<std::uint64_t>(step)});
    if (stream.uniform() < renewal) return stream.uniform() < share;
    --step;
  }
}

std::vector<LinkDelivery> arrived_until(std::span<const LinkDelivery> deliveries, double time_s) {
  std::vector<LinkDelivery> arrived;
  for (const LinkDelivery& delivery : deliveries) {
    if (delivery.fate == LinkFate::kDelivered && delivery.received_s <= time_s) {
      arrived.push_back(delivery);
    }
  }
  std::sort(arrived.begin(), arrived.end(), [](const LinkDelivery& a, const LinkDelivery& b) {
    return std::pair(a.received_s, a.id) < std::pair(b.received_s, b.id);
  });
  return arrived;
}

}  // namespace honka::sim
