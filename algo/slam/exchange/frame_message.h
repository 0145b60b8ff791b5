#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "algo/slam/sparse_frame.h"

namespace honka {

/// One key frame on its way from the edge to the cloud. The pose is the edge's own, counted from
/// its first frame and not from the frame before: a missing message leaves a gap and no break.
struct FrameMessage {
  std::uint8_t vehicle = 0;
  std::uint32_t sequence = 0;  ///< of the messages of this vehicle: what is missing was lost
  SparseFrame frame;
  Pose3 T_first_frame = Pose3::Identity();
};

/// Bytes of a message of so many stems: a header of 38 bytes and checksum, 6 bytes a stem.
[[nodiscard]] std::int64_t message_bytes(std::int64_t stems);

/// What a message keeps of its frame. Rounding errors of a value that is not saturated.
inline constexpr double kStemStep_m = 0.01;         ///< stems are whole centimetres: ± 0.005 m
inline constexpr double kStemLimit_m = 327.67;      ///< beyond it a coordinate saturates
inline constexpr double kPositionStep_m = 0.001;    ///< positions are whole millimetres
inline constexpr double kRotationError_rad = 7e-5;  ///< of a quaternion in four 16-bit numbers

enum class EncodeStatus : std::uint8_t {
  kEncoded,
  kSaturated,         ///< encoded; some coordinates lay beyond ±327.67 m and stand at the limit
  kPoseNotEncodable,  ///< no message: the pose is not finite, no rotation, or farther off than
                      ///< 2,147 km
  kNumberOutOfRange,  ///< no message: the frame number is below 0 or above 32 bits
  kTooManyStems,      ///< no message: more than 65,535
};
[[nodiscard]] std::string_view encode_status_name(EncodeStatus status);

struct EncodedFrame {
  EncodeStatus status = EncodeStatus::kEncoded;
  std::vector<std::uint8_t> bytes;  ///< empty where there is no message
  int stems_not_finite = 0;         ///< left out
  int stems_saturated = 0;          ///< with a coordinate at its limit
};
[[nodiscard]] EncodedFrame encode_frame(const FrameMessage& message);

enum class DecodeStatus : std::uint8_t {
  kDecoded,
  kWrongLength,     ///< shorter than a header, or not of the length that its stems need
  kNotAMessage,     ///< other first bytes
  kUnknownVersion,  ///< a later layout
  kDamaged,         ///< the checksum does not agree
  kBadPose,         ///< the quaternion has no length
};
[[nodiscard]] std::string_view decode_status_name(DecodeStatus status);

struct DecodedFrame {
  DecodeStatus status = DecodeStatus::kWrongLength;
  FrameMessage message;  ///< only where decoded
};
/// Reads any bytes; never throws, never gives a number that is not finite.
[[nodiscard]] DecodedFrame decode_frame(std::span<const std::uint8_t> bytes);

/// CRC-32 of IEEE 802.3 (reflected polynomial 0xEDB88320).
[[nodiscard]] std::uint32_t crc32_of(std::span<const std::uint8_t> bytes);

}  // namespace honka
