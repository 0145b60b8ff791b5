#include <catch2/catch.hpp>
#include <limits>

#include "algo/slam/exchange/frame_message.h"
#include "algo/types/random.h"

namespace honka {
namespace {

/// A key frame with stems within 60 m, anywhere within a kilometre, turned anyhow.
FrameMessage random_message(std::uint64_t seed, int stems) {
  RandomStream stream(seed, "test_exchange_message");
  FrameMessage message;
  message.vehicle = static_cast<std::uint8_t>(stream.below(256));
  message.sequence = stream.bits32();
  message.frame.number = stream.bits32();
  for (int i = 0; i < stems; ++i) {
    message.frame.points_m.emplace_back(stream.uniform(-60, 60), stream.uniform(-60, 60),
                                        stream.uniform(-9, 9));
  }
  message.T_first_frame = pose_from_rpy(
      {stream.uniform(-1e3, 1e3), stream.uniform(-1e3, 1e3), stream.uniform(-50, 50)},
      stream.uniform(-kPi, kPi), stream.uniform(-1.5, 1.5), stream.uniform(-kPi, kPi));
  return message;
}

double rotation_between_rad(const Pose3& a, const Pose3& b) {
  return Eigen::Quaterniond(a.linear()).angularDistance(Eigen::Quaterniond(b.linear()));
}

DecodeStatus decoded_status(const std::vector<std::uint8_t>& bytes) {
  return decode_frame(bytes).status;
}

}  // namespace

TEST_CASE("a message gives back its frame within the steps it is written in") {
  const int stems = GENERATE(0, 1, 2, 130, 3000);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const FrameMessage sent = random_message(seed, stems);
    const EncodedFrame encoded = encode_frame(sent);
    REQUIRE(encoded.status == EncodeStatus::kEncoded);
    REQUIRE(static_cast<std::int64_t>(encoded.bytes.size()) == message_bytes(stems));
    const DecodedFrame decoded = decode_frame(encoded.bytes);
    REQUIRE(decoded.status == DecodeStatus::kDecoded);
    const FrameMessage& got = decoded.message;
    REQUIRE(got.vehicle == sent.vehicle);
    REQUIRE(got.sequence == sent.sequence);
    REQUIRE(got.frame.number == sent.frame.number);
    REQUIRE(got.frame.points_m.size() == sent.frame.points_m.size());
    for (std::size_t i = 0; i < sent.frame.points_m.size(); ++i) {
      const Eigen::Vector3d error_m = got.frame.points_m[i] - sent.frame.points_m[i];
      REQUIRE(error_m.cwiseAbs().maxCoeff() <= 0.5 * kStemStep_m + 1e-12);
    }
    const Eigen::Vector3d moved_m =
        got.T_first_frame.translation() - sent.T_first_frame.translation();
    REQUIRE(moved_m.cwiseAbs().maxCoeff() <= 0.5 * kPositionStep_m + 1e-12);
    REQUIRE(rotation_between_rad(got.T_first_frame, sent.T_first_frame) <= kRotationError_rad);
    REQUIRE(got.T_first_frame.matrix().allFinite());
  }
}

TEST_CASE("a message of what was decoded is the same message") {
  const EncodedFrame once = encode_frame(random_message(3, 130));
  const EncodedFrame twice = encode_frame(decode_frame(once.bytes).message);
  // The quaternion was rounded: its last digit may move, everything else stays.
  REQUIRE(twice.bytes.size() == once.bytes.size());
  REQUIRE(std::equal(once.bytes.begin(), once.bytes.begin() + 24, twice.bytes.begin()));
  REQUIRE(std::equal(once.bytes.begin() + 32, once.bytes.end() - 4, twice.bytes.begin() + 32));
}

TEST_CASE("130 stems take 818 bytes, written in one byte order") {
  REQUIRE(message_bytes(130) == 818);
  FrameMessage message;
  message.vehicle = 7;
  message.sequence = 0x01020304;
  message.frame.number = 5;
  message.frame.points_m = {{1.0, -0.01, 2.56}};
  const auto bytes = encode_frame(message).bytes;
  const std::vector<std::uint8_t> expected = {
      'H', 'K', 1, 7, 4,   3,   2, 1, 5, 0, 0, 0, 0, 0, 0,   0, 0,   0,   0, 0,
      0,   0,   0, 0, 255, 127, 0, 0, 0, 0, 0, 0, 1, 0, 100, 0, 255, 255, 0, 1};
  REQUIRE(std::vector<std::uint8_t>(bytes.begin(), bytes.end() - 4) == expected);
}

TEST_CASE("the checksum is CRC-32 as everyone computes it") {
  const std::string digits = "123456789";
  REQUIRE(crc32_of(std::vector<std::uint8_t>(digits.begin(), digits.end())) == 0xCBF43926U);
  REQUIRE(crc32_of({}) == 0U);
}

TEST_CASE("stems that are not finite are left out and counted") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  FrameMessage message = random_message(1, 4);
  message.frame.points_m[1].y() = kNan;
  message.frame.points_m[2].z() = kInfinity;
  const EncodedFrame encoded = encode_frame(message);
  REQUIRE(encoded.status == EncodeStatus::kEncoded);
  REQUIRE(encoded.stems_not_finite == 2);
  const auto points_m = decode_frame(encoded.bytes).message.frame.points_m;
  REQUIRE(points_m.size() == 2);
  REQUIRE((points_m[1] - message.frame.points_m[3]).norm() < 0.01);
}

TEST_CASE("stems beyond the limit stand at the limit, and the status says so") {
  FrameMessage message;
  message.frame.points_m = {{327.674, -327.674, 0.0}, {400.0, 1.0, -1e300}};
  const EncodedFrame encoded = encode_frame(message);
  REQUIRE(encoded.status == EncodeStatus::kSaturated);
  REQUIRE(encoded.stems_saturated == 1);
  const auto points_m = decode_frame(encoded.bytes).message.frame.points_m;
  REQUIRE(points_m[0].isApprox(Eigen::Vector3d(kStemLimit_m, -kStemLimit_m, 0.0), 1e-9));
  REQUIRE(points_m[1].isApprox(Eigen::Vector3d(kStemLimit_m, 1.0, -kStemLimit_m), 1e-9));
}

TEST_CASE("what no message can hold is refused by a status") {
  FrameMessage message = random_message(1, 3);
  EncodeStatus expected = EncodeStatus::kPoseNotEncodable;
  SECTION("a pose that is not finite") {
    message.T_first_frame.translation().x() = std::numeric_limits<double>::quiet_NaN();
  }
  SECTION("a pose too far off") { message.T_first_frame.translation().y() = -3e6; }
  SECTION("a pose that is no rotation") { message.T_first_frame.linear() *= 2.0; }
  SECTION("a negative number") {
    message.frame.number = -1;
    expected = EncodeStatus::kNumberOutOfRange;
  }
  SECTION("a number above 32 bits") {
    message.frame.number = std::int64_t{1} << 32U;
    expected = EncodeStatus::kNumberOutOfRange;
  }
  SECTION("too many stems") {
    message.frame.points_m.assign(65536, Eigen::Vector3d::Zero());
    expected = EncodeStatus::kTooManyStems;
  }
  const EncodedFrame encoded = encode_frame(message);
  REQUIRE(encoded.status == expected);
  REQUIRE(encoded.bytes.empty());
}

TEST_CASE("every damaged byte and every cut is noticed") {
  const auto bytes = encode_frame(random_message(2, 20)).bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const int flip : {0x01, 0x80, 0xFF}) {
      auto damaged = bytes;
      damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ flip);
      REQUIRE(decoded_status(damaged) != DecodeStatus::kDecoded);
    }
    REQUIRE(decoded_status({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(i)}) !=
            DecodeStatus::kDecoded);
  }
  auto longer = bytes;
  longer.push_back(0);
  REQUIRE(decoded_status(longer) == DecodeStatus::kWrongLength);
  REQUIRE(decoded_status({}) == DecodeStatus::kWrongLength);
}

TEST_CASE("random bytes and messages with many damaged bytes never pass") {
  RandomStream stream(11, "test_exchange_fuzz");
  const auto bytes = encode_frame(random_message(5, 30)).bytes;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::uint8_t> noise(stream.below(400));
    for (auto& byte : noise) byte = static_cast<std::uint8_t>(stream.below(256));
    REQUIRE(decoded_status(noise) != DecodeStatus::kDecoded);
    auto damaged = bytes;
    for (std::uint64_t i = 0; i <= stream.below(30); ++i) {
      damaged[stream.below(damaged.size())] ^= static_cast<std::uint8_t>(1 + stream.below(255));
    }
    if (damaged != bytes) REQUIRE(decoded_status(damaged) != DecodeStatus::kDecoded);
  }
}

TEST_CASE("each fault has its own status") {
  auto bytes = encode_frame(random_message(2, 2)).bytes;
  const auto sealed = [](std::vector<std::uint8_t> message) {
    const std::uint32_t crc = crc32_of(std::span(message).first(message.size() - 4));
    for (unsigned i = 0; i < 4; ++i) {
      message[message.size() - 4 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    }
    return message;
  };
  REQUIRE(sealed(bytes) == bytes);
  SECTION("mark") {
    bytes[0] = 'X';
    REQUIRE(decoded_status(sealed(bytes)) == DecodeStatus::kNotAMessage);
  }
  SECTION("version") {
    bytes[2] = 2;
    REQUIRE(decoded_status(sealed(bytes)) == DecodeStatus::kUnknownVersion);
  }
  SECTION("number of stems") {
    bytes[32] = 3;
    REQUIRE(decoded_status(sealed(bytes)) == DecodeStatus::kWrongLength);
  }
  SECTION("checksum") {
    bytes[10] ^= 1;
    REQUIRE(decoded_status(bytes) == DecodeStatus::kDamaged);
    REQUIRE(decoded_status(sealed(bytes)) == DecodeStatus::kDecoded);
  }
  SECTION("pose") {
    std::fill(bytes.begin() + 24, bytes.begin() + 32, std::uint8_t{0});
    REQUIRE(decoded_status(sealed(bytes)) == DecodeStatus::kBadPose);
  }
}

}  // namespace honka
