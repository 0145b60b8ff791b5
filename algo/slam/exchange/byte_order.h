#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algo/types/check.h"

namespace honka {

/// Adds numbers to bytes, least significant byte first on every machine.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  void u8(std::uint8_t value) { bytes_.push_back(value); }
  void u16(std::uint16_t value) { add(value, 2); }
  void u32(std::uint32_t value) { add(value, 4); }
  void i16(std::int16_t value) { u16(static_cast<std::uint16_t>(value)); }
  void i32(std::int32_t value) { u32(static_cast<std::uint32_t>(value)); }

 private:
  void add(std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) {
      bytes_.push_back(static_cast<std::uint8_t>(value >> (8U * static_cast<unsigned>(i))));
    }
  }
  std::vector<std::uint8_t>& bytes_;
};

/// Takes numbers off bytes; the caller has checked that they are there.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  [[nodiscard]] std::uint8_t u8() { return static_cast<std::uint8_t>(take(1)); }
  [[nodiscard]] std::uint16_t u16() { return static_cast<std::uint16_t>(take(2)); }
  [[nodiscard]] std::uint32_t u32() { return take(4); }
  [[nodiscard]] std::int16_t i16() { return static_cast<std::int16_t>(u16()); }
  [[nodiscard]] std::int32_t i32() { return static_cast<std::int32_t>(u32()); }

 private:
  std::uint32_t take(std::size_t size) {
    HONKA_CHECK(next_ + size <= bytes_.size(), "the length was checked before");
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i) {
      value |= static_cast<std::uint32_t>(bytes_[next_ + i]) << (8U * i);
    }
    next_ += size;
    return value;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t next_ = 0;
};

}  // namespace honka
