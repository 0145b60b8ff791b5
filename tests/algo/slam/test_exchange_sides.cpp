#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <type_traits>

#include "algo/slam/exchange/cloud_receiver.h"
#include "algo/slam/exchange/edge_sender.h"
#include "algo/types/random.h"

namespace honka {
namespace {

/// Key frame `number` of a drive along x, a metre a frame: stems in a row across.
SparseFrame exchange_frame(std::int64_t number, int stems = 50) {
  SparseFrame frame{number, {}};
  for (int i = 0; i < stems; ++i) frame.points_m.emplace_back(0.25 * i, number % 7, 0.5);
  return frame;
}

Pose3 exchange_pose(std::int64_t number) {
  return pose_from_rpy({static_cast<double>(number), 0.0, 0.0}, 0.0, 0.0, 0.01 * double(number));
}

/// Key frames come in hops of 20 within 5 s, with 10 s of rest between.
double exchange_time_s(std::int64_t number) {
  return 100.0 + 15.0 * static_cast<double>(number / 20) + 0.25 * static_cast<double>(number % 20);
}

std::vector<EdgeMessage> send_frames(EdgeSender& sender, std::int64_t frames) {
  std::vector<EdgeMessage> messages;
  for (std::int64_t n = 0; n < frames; ++n) {
    auto message = sender.offer(exchange_frame(n), exchange_pose(n), exchange_time_s(n));
    if (message) messages.push_back(std::move(*message));
  }
  return messages;
}

/// What waits in a queue before a radio of this bandwidth, at most. Bytes.
double longest_queue(const std::vector<EdgeMessage>& messages, const Uplink& uplink) {
  double free_s = 0.0, longest = 0.0;
  for (const EdgeMessage& message : messages) {
    const double bytes =
        static_cast<double>(message.bytes.size()) + static_cast<double>(uplink.overhead_bytes);
    const double waits = std::max(0.0, (free_s - message.time_s) * uplink.bandwidth_bytes_per_s);
    if (waits > 0.0) longest = std::max(longest, waits + bytes);
    free_s = std::max(free_s, message.time_s) + bytes / uplink.bandwidth_bytes_per_s;
  }
  return longest;
}

/// Mean need of the drive above, 50 stems a frame and 28 bytes of overhead. Bytes a second.
double exchange_need() { return 20.0 * static_cast<double>(message_bytes(50) + 28) / 15.0; }

template <class Frames>
concept CanBeFilledByHand = requires(Frames frames) {
  Frames{std::vector<SparseFrame>{}};
};

}  // namespace

TEST_CASE("policies of the edge") {
  const Uplink unbounded;
  SECTION("all") {
    EdgeSender sender({.policy = "all"}, unbounded);
    CHECK(send_frames(sender, 100).size() == 100);
  }
  SECTION("every third") {
    EdgeSender sender({.policy = "every_kth", .stride = 3}, unbounded);
    const auto messages = send_frames(sender, 100);
    REQUIRE(messages.size() == 34);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      CHECK(messages[i].frame_number == static_cast<std::int64_t>(3 * i));
      CHECK(messages[i].sequence == i);
    }
    CHECK(sender.tally().held_back == 66);
    CHECK(sender.tally().bytes_sent == 34 * message_bytes(50));
    CHECK(sender.tally().bytes_offered == 100 * message_bytes(50));
  }
  SECTION("paced, unbounded") {
    EdgeSender sender({.policy = "paced"}, unbounded);
    CHECK(send_frames(sender, 100).size() == 100);
  }
}

TEST_CASE("paced never fills the queue and spreads what is missing evenly") {
  const double share = GENERATE(1.0, 0.5, 0.3, 0.1, 0.03);
  const Uplink uplink{share * exchange_need(), 8000, 28};
  const EdgeSettings settings{.policy = "paced", .longest_wait_s = 20.0};
  EdgeSender sender(settings, uplink);
  const std::int64_t frames = 2000;
  const auto messages = send_frames(sender, frames);
  const auto sent = static_cast<double>(messages.size());
  CAPTURE(share, sent);
  CHECK(longest_queue(messages, uplink) <= 8000.0);
  CHECK(longest_queue(messages, uplink) <= 20.0 * uplink.bandwidth_bytes_per_s + 1e-6);
  CHECK(sent <= 1.1 * share * frames);
  CHECK(sent >= 0.8 * share * frames);
  std::int64_t longest_gap = messages.front().frame_number;
  for (std::size_t i = 1; i < messages.size(); ++i) {
    longest_gap = std::max(longest_gap, messages[i].frame_number - messages[i - 1].frame_number);
  }
  CHECK(messages.front().frame_number == 0);
  // Within a hop the radio falls behind; over the rest it catches up.
  CHECK(longest_gap <= 20 + 2.0 / share);
}

TEST_CASE("frames that no message can hold are counted, the rest goes on") {
  EdgeSender sender({.policy = "all"}, {});
  Pose3 lost = Pose3::Identity();
  lost.translation().x() = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(sender.offer(exchange_frame(0), lost, 0.0));
  SparseFrame frame = exchange_frame(1, 5);
  frame.points_m[2].x() = std::numeric_limits<double>::quiet_NaN();
  const auto message = sender.offer(frame, exchange_pose(1), 1.0);
  REQUIRE(message);
  CHECK(message->sequence == 0);
  CHECK(sender.tally().not_encodable == 1);
  CHECK(sender.tally().stems_not_finite == 1);
  CHECK(sender.tally().sent == 1);
}

TEST_CASE("the cloud gathers frames in order of number from whatever arrives") {
  EdgeSender sender({.policy = "all"}, {});
  auto messages = send_frames(sender, 40);
  // Frames 10–14, 20 and 39 are lost; the rest comes in any order, some of it twice.
  std::erase_if(messages, [](const EdgeMessage& m) {
    return (m.frame_number >= 10 && m.frame_number < 15) || m.frame_number == 20 ||
           m.frame_number == 39;
  });
  RandomStream stream(1, "test_exchange_order");
  for (std::size_t i = messages.size(); i > 1; --i) {
    std::swap(messages[i - 1], messages[stream.below(i)]);
  }
  CloudReceiver receiver;
  for (const EdgeMessage& m : messages) REQUIRE(receiver.receive(m.bytes) == ReceiveStatus::kNew);
  CHECK(receiver.receive(messages[3].bytes) == ReceiveStatus::kDuplicate);
  auto damaged = messages[4].bytes;
  damaged[20] ^= 4;
  CHECK(receiver.receive(damaged) == ReceiveStatus::kRefused);

  const ReceivedFrames got = receiver.received();
  REQUIRE(got.frames().size() == 33);
  CHECK(std::is_sorted(got.frames().begin(), got.frames().end(),
                       [](const auto& a, const auto& b) { return a.number < b.number; }));
  REQUIRE(got.gaps().size() == 2);
  CHECK(got.gaps()[0].after == 9);
  CHECK(got.gaps()[0].before == 15);
  CHECK(got.gaps()[0].missing() == 5);
  CHECK(got.gaps()[1].missing() == 1);
  for (std::size_t i = 0; i < got.frames().size(); ++i) {
    const Pose3 error =
        got.edge_T_first_frame()[i].inverse() * exchange_pose(got.frames()[i].number);
    CHECK(error.translation().norm() < 0.002);
  }
  const CloudTally tally = receiver.tally();
  CHECK(tally.messages == 35);
  CHECK(tally.frames == 33);
  CHECK(tally.duplicates == 1);
  CHECK(tally.refused == 1);
  CHECK(tally.refused_by_status[static_cast<std::size_t>(DecodeStatus::kDamaged)] == 1);
  // The last message is missing too; no later one tells of it.
  CHECK(tally.lost_messages == 6);
}

TEST_CASE("poses count from the first frame that arrived") {
  EdgeSender sender({.policy = "every_kth", .stride = 4}, {}, 3);
  const auto messages = send_frames(sender, 40);
  CloudReceiver receiver(3);
  for (std::size_t i = 2; i < messages.size(); ++i) (void)receiver.receive(messages[i].bytes);
  const ReceivedFrames got = receiver.received();
  REQUIRE(got.frames().front().number == 8);
  CHECK(got.edge_T_first_frame().front().matrix() == Pose3::Identity().matrix());
  const Pose3 expected = exchange_pose(8).inverse() * exchange_pose(36);
  CHECK((got.edge_T_first_frame().back().translation() - expected.translation()).norm() < 0.005);
  // Gaps by the edge's choice are gaps of numbers, yet no message is missing after the first.
  CHECK(got.gaps().size() == 7);
  CHECK(receiver.tally().lost_messages == 2);
}

TEST_CASE("nothing and other vehicles give an empty map's worth") {
  CloudReceiver receiver(1);
  CHECK(receiver.received().empty());
  CHECK(receiver.tally().lost_messages == 0);
  EdgeSender other({.policy = "all"}, {}, 2);
  for (const EdgeMessage& m : send_frames(other, 3)) {
    CHECK(receiver.receive(m.bytes) == ReceiveStatus::kOtherVehicle);
  }
  CHECK(receiver.received().empty());
  CHECK(receiver.tally().other_vehicle == 3);
}

TEST_CASE("only a receiver makes received frames") {
  STATIC_REQUIRE_FALSE(std::is_default_constructible_v<ReceivedFrames>);
  STATIC_REQUIRE_FALSE(CanBeFilledByHand<ReceivedFrames>);
}

}  // namespace honka
