#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "algo/types/random.h"
#include "algo/types/user_error.h"
#include "sim/link/radio_link.h"

namespace honka::sim {
namespace {

/// Messages of 1 to 2,000 bytes, some of them at the same moment.
std::vector<LinkMessage> random_messages(int count, double mean_gap_s, std::uint64_t seed) {
  std::vector<LinkMessage> messages;
  RandomStream stream(seed, "test_link_messages");
  double time_s = 3.0;
  for (int i = 0; i < count; ++i) {
    if (stream.uniform() < 0.8) time_s += stream.uniform(0.0, 2.5 * mean_gap_s);
    messages.push_back({static_cast<std::uint64_t>(i) + 7,
                        static_cast<std::int64_t>(1 + stream.below(2000)), time_s});
  }
  return messages;
}

LinkSettings unbounded_link() {
  LinkSettings settings;
  settings.queue_bytes = 0;
  return settings;
}

std::size_t count_fate(const std::vector<LinkDelivery>& deliveries, LinkFate fate) {
  return static_cast<std::size_t>(std::count_if(deliveries.begin(), deliveries.end(),
                                                [&](const auto& d) { return d.fate == fate; }));
}

/// Every pattern of the link's settings that the laws below are held against.
std::vector<LinkSettings> link_variants() {
  std::vector<LinkSettings> variants;
  for (const double bandwidth : {0.0, 300.0, 1e4}) {
    for (const char* pattern : {"independent", "bursts"}) {
      for (const char* full : {"drop_oldest", "drop_newest"}) {
        LinkSettings s;
        s.bandwidth_bytes_per_s = bandwidth;
        s.loss = 0.3;
        s.loss_pattern = pattern;
        s.delay_s = 0.4;
        s.jitter_s = 20.0;
        s.queue_bytes = 5000;
        s.queue_full = full;
        variants.push_back(s);
      }
    }
  }
  return variants;
}

}  // namespace

TEST_CASE("laws of every link") {
  const LinkSettings settings = GENERATE(from_range(link_variants()));
  const auto messages = random_messages(600, 0.3, 1);
  const auto deliveries = RadioLink(settings, 5).carry(messages);
  REQUIRE(deliveries.size() == messages.size());

  SECTION("each message has one fate, and none arrives before its time") {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const LinkDelivery& d = deliveries[i];
      REQUIRE(d.id == messages[i].id);
      const bool was_on_air = d.fate == LinkFate::kDelivered || d.fate == LinkFate::kLostOnAir;
      REQUIRE(d.bytes_on_air == (was_on_air ? messages[i].bytes + settings.overhead_bytes : 0));
      if (was_on_air) REQUIRE(d.air_start_s >= messages[i].sent_s);
      if (d.fate != LinkFate::kDelivered) continue;
      REQUIRE(d.received_s >= d.air_end_s + settings.delay_s);
      REQUIRE(d.received_s <= d.air_end_s + settings.delay_s + settings.jitter_s);
    }
  }
  SECTION("no window of time carries more than the bandwidth") {
    if (settings.bandwidth_bytes_per_s == 0.0) return;
    std::vector<LinkDelivery> on_air;
    std::copy_if(deliveries.begin(), deliveries.end(), std::back_inserter(on_air),
                 [](const auto& d) { return d.bytes_on_air > 0; });
    REQUIRE(on_air.size() > 20);
    double most_excess = 0.0;
    for (std::size_t a = 0; a < on_air.size(); ++a) {
      double bytes = 0.0;
      for (std::size_t b = a; b < on_air.size(); ++b) {
        bytes += static_cast<double>(on_air[b].bytes_on_air);
        const double window_s = on_air[b].air_end_s - on_air[a].air_start_s;
        most_excess = std::max(most_excess, bytes - settings.bandwidth_bytes_per_s * window_s);
      }
    }
    REQUIRE(most_excess < 1e-3);
  }
  SECTION("the same digits, whatever the order in which the messages are given") {
    auto reversed = messages;
    std::reverse(reversed.begin(), reversed.end());
    const auto again = RadioLink(settings, 5).carry(reversed);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const LinkDelivery& other = again[messages.size() - 1 - i];
      REQUIRE(deliveries[i].fate == other.fate);
      REQUIRE(deliveries[i].received_s == other.received_s);
    }
  }
  SECTION("another seed, another chance") {
    const auto other = RadioLink(settings, 6).carry(messages);
    REQUIRE_FALSE(std::equal(deliveries.begin(), deliveries.end(), other.begin(),
                             [](const auto& a, const auto& b) { return a.fate == b.fate; }));
  }
}

TEST_CASE("an unbounded link without loss passes everything, at once and in order") {
  LinkSettings settings = unbounded_link();
  settings.delay_s = 2.0;
  const auto messages = random_messages(300, 0.1, 2);
  const auto deliveries = RadioLink(settings, 1).carry(messages);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    REQUIRE(deliveries[i].fate == LinkFate::kDelivered);
    REQUIRE(deliveries[i].received_s == messages[i].sent_s + 2.0);
  }
  REQUIRE(arrived_until(deliveries, 1e9).size() == messages.size());
  REQUIRE(arrived_until(deliveries, 4.9).empty());
  REQUIRE(RadioLink(settings, 1).carry({}).empty());
}

TEST_CASE("a loss of 1 loses everything, in both patterns") {
  LinkSettings settings = unbounded_link();
  settings.loss = 1.0;
  settings.loss_pattern = GENERATE("independent", "bursts");
  const auto deliveries = RadioLink(settings, 3).carry(random_messages(500, 0.3, 3));
  REQUIRE(count_fate(deliveries, LinkFate::kLostOnAir) == deliveries.size());
  REQUIRE(arrived_until(deliveries, 1e9).empty());
}

TEST_CASE("independent loss lies within its binomial interval") {
  LinkSettings settings = unbounded_link();
  settings.loss = GENERATE(0.01, 0.1, 0.5);
  const int count = 20000;
  const auto deliveries = RadioLink(settings, 4).carry(random_messages(count, 0.01, 4));
  const auto lost = static_cast<double>(count_fate(deliveries, LinkFate::kLostOnAir));
  const double sd = std::sqrt(count * settings.loss * (1.0 - settings.loss));
  CHECK(std::fabs(lost - count * settings.loss) < 4.0 * sd);
}

TEST_CASE("bad spells have the asked length and lose the asked share") {
  LinkSettings settings = unbounded_link();
  settings.loss_pattern = "bursts";
  settings.burst_s = 4.0;
  settings.loss = 0.3;
  settings.burst_loss = GENERATE(1.0, 0.6);
  const RadioLink link(settings, 9);
  // A message every 0.2 s for 20,000 s: some 2,000 spells of each kind.
  const int count = 100000;
  int lost = 0, lost_pairs = 0;
  bool was_lost = false;
  for (int i = 0; i < count; ++i) {
    const bool is_lost = link.is_lost(static_cast<std::uint64_t>(i), 0.2 * i);
    lost += is_lost ? 1 : 0;
    lost_pairs += is_lost && was_lost ? 1 : 0;
    was_lost = is_lost;
  }
  CHECK(static_cast<double>(lost) / count == Approx(0.3).margin(0.02));
  // Within 0.2 s, half a step of a spell's ten, a spell ends with probability 0.2 / 4.
  const double stays = settings.burst_loss * (1.0 - 0.2 / settings.burst_s);
  CHECK(static_cast<double>(lost_pairs) / lost == Approx(stays).margin(0.02));
}

TEST_CASE("jitter changes the order of arrival, a fixed delay does not") {
  LinkSettings settings = unbounded_link();
  settings.jitter_s = GENERATE(0.0, 10.0);
  const auto arrived =
      arrived_until(RadioLink(settings, 2).carry(random_messages(200, 0.5, 5)), 1e9);
  REQUIRE(arrived.size() == 200);
  const bool in_order = std::is_sorted(arrived.begin(), arrived.end(),
                                       [](const auto& a, const auto& b) { return a.id < b.id; });
  CHECK(in_order == (settings.jitter_s == 0.0));
}

TEST_CASE("a full queue drops the oldest or the newest") {
  // Ten messages of 100 bytes at once onto 100 B/s; one on the air, three in the queue.
  LinkSettings settings;
  settings.bandwidth_bytes_per_s = 100.0;
  settings.overhead_bytes = 0;
  settings.queue_bytes = 300;
  settings.delay_s = 0.0;
  std::vector<LinkMessage> messages;
  for (std::uint64_t id = 0; id < 10; ++id) messages.push_back({id, 100, 1.0});
  const auto ids_delivered = [&] {
    std::vector<std::uint64_t> ids;
    for (const auto& d : arrived_until(RadioLink(settings, 1).carry(messages), 1e9)) {
      ids.push_back(d.id);
    }
    return ids;
  };
  SECTION("oldest") {
    settings.queue_full = "drop_oldest";
    CHECK(ids_delivered() == std::vector<std::uint64_t>{0, 7, 8, 9});
  }
  SECTION("newest") {
    settings.queue_full = "drop_newest";
    CHECK(ids_delivered() == std::vector<std::uint64_t>{0, 1, 2, 3});
  }
  SECTION("times on the air follow each other") {
    settings.queue_full = "drop_newest";
    const auto deliveries = RadioLink(settings, 1).carry(messages);
    CHECK(deliveries[0].air_end_s == 2.0);
    CHECK(deliveries[3].air_end_s == 5.0);
    CHECK(deliveries[4].fate == LinkFate::kQueueFull);
  }
  SECTION("what is larger than the queue never leaves the edge") {
    messages = {{1, 301, 0.0}, {2, 300, 0.0}};
    const auto deliveries = RadioLink(settings, 1).carry(messages);
    CHECK(deliveries[0].fate == LinkFate::kTooLarge);
    CHECK(deliveries[1].fate == LinkFate::kDelivered);
  }
}

TEST_CASE("bad spells that cannot make the loss are refused") {
  LinkSettings settings;
  settings.loss_pattern = "bursts";
  settings.loss = 0.5;
  settings.burst_loss = 0.4;
  REQUIRE_THROWS_WITH(RadioLink(settings, 1), Catch::Contains("link.burst_loss = 0.4"));
  settings.loss_pattern = "independent";
  REQUIRE_NOTHROW(RadioLink(settings, 1));
}

}  // namespace honka::sim
