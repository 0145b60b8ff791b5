#include <array>

#include "algo/slam/exchange/frame_message.h"

namespace honka {
namespace {

constexpr std::array<std::uint32_t, 256> crc32_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) {
      rest = (rest & 1U) != 0U ? (rest >> 1U) ^ 0xEDB88320U : rest >> 1U;
    }
    table[byte] = rest;
  }
  return table;
}

}  // namespace

std::uint32_t crc32_of(std::span<const std::uint8_t> bytes) {
  static constexpr auto kTable = crc32_table();
  std::uint32_t rest = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) rest = kTable[(rest ^ byte) & 0xFFU] ^ (rest >> 8U);
  return rest ^ 0xFFFFFFFFU;
}

}  // namespace honka
