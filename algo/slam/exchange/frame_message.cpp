#include "algo/slam/exchange/frame_message.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include "algo/slam/exchange/byte_order.h"

namespace honka {
namespace {

// Layout, little-endian, by bytes: 0 mark, 2 version, 3 vehicle, 4 sequence, 8 frame number,
// 12 position (3 × i32, mm), 24 quaternion w x y z (4 × i16, 1/32767), 32 stems (u16),
// 34 stems (3 × i16 each, cm), checksum (u32) over all before it.
constexpr std::uint16_t kMessageMark = 0x4B48;  // "HK"
constexpr std::uint8_t kMessageVersion = 1;
constexpr std::size_t kHeaderBytes = 34;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::size_t kStemBytes = 6;
constexpr double kLargest16 = 32767.0;
constexpr double kLargest32 = 2147483647.0;

std::vector<Eigen::Vector3d> finite_stems(const std::vector<Eigen::Vector3d>& points_m) {
  std::vector<Eigen::Vector3d> finite;
  std::copy_if(points_m.begin(), points_m.end(), std::back_inserter(finite),
               [](const Eigen::Vector3d& p) { return p.allFinite(); });
  return finite;
}

bool is_rotation(const Eigen::Matrix3d& matrix) {
  return (matrix.transpose() * matrix - Eigen::Matrix3d::Identity()).norm() < 1e-6;
}

std::optional<EncodeStatus> refusal_of(const FrameMessage& message, std::size_t stems) {
  const Pose3& pose = message.T_first_frame;
  if (!pose.matrix().allFinite() || !is_rotation(pose.linear()) ||
      pose.translation().cwiseAbs().maxCoeff() > kLargest32 * kPositionStep_m) {
    return EncodeStatus::kPoseNotEncodable;
  }
  if (message.frame.number < 0 ||
      message.frame.number > std::numeric_limits<std::uint32_t>::max()) {
    return EncodeStatus::kNumberOutOfRange;
  }
  if (stems > std::numeric_limits<std::uint16_t>::max()) return EncodeStatus::kTooManyStems;
  return std::nullopt;
}

void write_pose(ByteWriter& out, const Pose3& pose) {
  for (const double metres : pose.translation()) {
    out.i32(static_cast<std::int32_t>(std::lround(metres / kPositionStep_m)));
  }
  Eigen::Quaterniond q(pose.linear());
  q.normalize();
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  for (const double part : {q.w(), q.x(), q.y(), q.z()}) {
    out.i16(static_cast<std::int16_t>(std::lround(part * kLargest16)));
  }
}

/// Whether a coordinate of the stem lay beyond the limit.
bool write_stem(ByteWriter& out, const Eigen::Vector3d& stem_m) {
  bool is_saturated = false;
  for (const double metres : stem_m) {
    const double steps = std::round(metres / kStemStep_m);
    is_saturated |= std::fabs(steps) > kLargest16;
    out.i16(static_cast<std::int16_t>(std::clamp(steps, -kLargest16, kLargest16)));
  }
  return is_saturated;
}

Eigen::Vector3d read_position(ByteReader& in) {
  const std::int32_t x = in.i32(), y = in.i32(), z = in.i32();
  return Eigen::Vector3d(x, y, z) * kPositionStep_m;
}

Eigen::Vector3d read_stem(ByteReader& in) {
  const std::int16_t x = in.i16(), y = in.i16(), z = in.i16();
  return Eigen::Vector3d(x, y, z) * kStemStep_m;
}

std::optional<DecodeStatus> fault_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes + kChecksumBytes) return DecodeStatus::kWrongLength;
  ByteReader in(bytes);
  if (in.u16() != kMessageMark) return DecodeStatus::kNotAMessage;
  if (in.u8() != kMessageVersion) return DecodeStatus::kUnknownVersion;
  const std::size_t stems = ByteReader(bytes.subspan(kHeaderBytes - 2)).u16();
  if (bytes.size() != static_cast<std::size_t>(message_bytes(static_cast<std::int64_t>(stems)))) {
    return DecodeStatus::kWrongLength;
  }
  const std::size_t body = bytes.size() - kChecksumBytes;
  if (ByteReader(bytes.subspan(body)).u32() != crc32_of(bytes.first(body))) {
    return DecodeStatus::kDamaged;
  }
  return std::nullopt;
}

}  // namespace

std::int64_t message_bytes(std::int64_t stems) {
  return static_cast<std::int64_t>(kHeaderBytes + kChecksumBytes) +
         static_cast<std::int64_t>(kStemBytes) * stems;
}

std::string_view encode_status_name(EncodeStatus status) {
  switch (status) {
    case EncodeStatus::kEncoded:
      return "encoded";
    case EncodeStatus::kSaturated:
      return "saturated";
    case EncodeStatus::kPoseNotEncodable:
      return "pose_not_encodable";
    case EncodeStatus::kNumberOutOfRange:
      return "number_out_of_range";
    case EncodeStatus::kTooManyStems:
      return "too_many_stems";
  }
  return "";
}

std::string_view decode_status_name(DecodeStatus status) {
  switch (status) {
    case DecodeStatus::kDecoded:
      return "decoded";
    case DecodeStatus::kWrongLength:
      return "wrong_length";
    case DecodeStatus::kNotAMessage:
      return "not_a_message";
    case DecodeStatus::kUnknownVersion:
      return "unknown_version";
    case DecodeStatus::kDamaged:
      return "damaged";
    case DecodeStatus::kBadPose:
      return "bad_pose";
  }
  return "";
}

EncodedFrame encode_frame(const FrameMessage& message) {
  EncodedFrame encoded;
  const auto stems_m = finite_stems(message.frame.points_m);
  encoded.stems_not_finite = static_cast<int>(message.frame.points_m.size() - stems_m.size());
  if (const auto refusal = refusal_of(message, stems_m.size())) {
    encoded.status = *refusal;
    return encoded;
  }
  ByteWriter out(encoded.bytes);
  out.u16(kMessageMark);
  out.u8(kMessageVersion);
  out.u8(message.vehicle);
  out.u32(message.sequence);
  out.u32(static_cast<std::uint32_t>(message.frame.number));
  write_pose(out, message.T_first_frame);
  out.u16(static_cast<std::uint16_t>(stems_m.size()));
  for (const Eigen::Vector3d& stem_m : stems_m) {
    if (write_stem(out, stem_m)) ++encoded.stems_saturated;
  }
  out.u32(crc32_of(encoded.bytes));
  if (encoded.stems_saturated > 0) encoded.status = EncodeStatus::kSaturated;
  return encoded;
}

DecodedFrame decode_frame(std::span<const std::uint8_t> bytes) {
  DecodedFrame decoded;
  if (const auto fault = fault_of(bytes)) {
    decoded.status = *fault;
    return decoded;
  }
  ByteReader in(bytes.subspan(3));
  FrameMessage& message = decoded.message;
  message.vehicle = in.u8();
  message.sequence = in.u32();
  message.frame.number = in.u32();
  message.T_first_frame.translation() = read_position(in);
  const std::int16_t w = in.i16(), x = in.i16(), y = in.i16(), z = in.i16();
  Eigen::Quaterniond q(w, x, y, z);
  // A true one has a length of 32767; half of it is no rounding.
  if (q.norm() < 0.5 * kLargest16) {
    decoded.status = DecodeStatus::kBadPose;
    return decoded;
  }
  message.T_first_frame.linear() = q.normalized().toRotationMatrix();
  const std::uint16_t stems = in.u16();
  for (std::uint16_t i = 0; i < stems; ++i) message.frame.points_m.push_back(read_stem(in));
  decoded.status = DecodeStatus::kDecoded;
  return decoded;
}

}  // namespace honka
