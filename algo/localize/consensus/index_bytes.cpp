#include <fmt/format.h>

#include <array>
#include <utility>

#include "algo/localize/consensus/bytes.h"
#include "algo/localize/consensus/index.h"
#include "algo/types/random.h"

namespace honka {
namespace {

constexpr std::array<char, 8> kIndexMagic = {'h', 'o', 'n', 'k', 'a', 'i', 'd', 'x'};
constexpr std::uint64_t kIndexVersion = 1;  // rises with every change of the layout or of the table

[[noreturn]] void refuse(std::string_view reason) {
  throw UserError(fmt::format("{}; remove the index and build it again", reason));
}

}  // namespace

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  // Four chains, so that the mixing of one does not wait for that of another.
  std::array<std::uint64_t, 4> lanes = {1, 2, 3, 4};
  std::size_t at = 0;
  for (; at + 32 <= bytes.size(); at += 32) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::uint64_t word;
      std::memcpy(&word, bytes.data() + at + 8 * k, 8);
      lanes[k] = mix64(lanes[k] ^ word);
    }
  }
  for (; at < bytes.size(); ++at) lanes[0] = mix64(lanes[0] ^ bytes[at]);
  return mix64(lanes[0] ^ mix64(lanes[1] ^ mix64(lanes[2] ^ mix64(lanes[3] ^ bytes.size()))));
}

std::vector<std::uint8_t> ConsensusIndex::to_bytes() const {
  ByteWriter content;
  content.value(centre_m_.x());
  content.value(centre_m_.y());
  std::vector<std::array<double, 2>> stems;
  for (const Eigen::Vector2d& p : grid_.stems()) stems.push_back({p.x(), p.y()});
  content.list(stems);
  groups_.write(content);
  ByteWriter all;
  all.bytes().reserve(content.bytes().size() + 64);
  all.value(kIndexMagic);
  all.value(kIndexVersion);
  all.value(hash_);
  all.value(static_cast<std::uint64_t>(content.bytes().size()));
  all.value(checksum(content.bytes()));
  all.bytes().insert(all.bytes().end(), content.bytes().begin(), content.bytes().end());
  return std::move(all.bytes());
}

ConsensusIndex ConsensusIndex::from_bytes(std::span<const std::uint8_t> bytes) {
  // The header says whose the bytes are and whether all have arrived
  ByteReader in(bytes);
  if (in.value<std::array<char, 8>>() != kIndexMagic) refuse("this is not the index of a map");
  const auto version = in.value<std::uint64_t>();
  if (version != kIndexVersion) {
    refuse(fmt::format("the index has version {}, this program reads {}", version, kIndexVersion));
  }
  ConsensusIndex index;
  index.hash_ = in.value<std::uint64_t>();
  const auto length = in.value<std::uint64_t>();
  const auto sum = in.value<std::uint64_t>();
  if (in.rest().size() != length) {
    refuse(fmt::format("the index should have {} bytes and has {}", length, in.rest().size()));
  }
  if (checksum(in.rest()) != sum) refuse("the index is damaged: its checksum differs");

  // The content
  index.centre_m_.x() = in.value<double>();
  index.centre_m_.y() = in.value<double>();
  std::vector<Eigen::Vector2d> stems;
  for (const auto& [x, y] : in.list<std::array<double, 2>>()) stems.emplace_back(x, y);
  index.grid_ = StemGrid(std::move(stems));
  index.groups_ = GroupTable::read(in);
  if (!index.groups_.belongs_to(index.grid_)) refuse("the index does not fit its own stems");
  return index;
}

}  // namespace honka
