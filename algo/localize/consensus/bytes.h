#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "algo/types/large_pages.h"
#include "algo/types/user_error.h"

namespace honka {

static_assert(std::endian::native == std::endian::little, "an index is stored little-endian");

/// 64-bit checksum of a buffer.
[[nodiscard]] std::uint64_t checksum(std::span<const std::uint8_t> bytes);

/// Appends plain values and lists of them to a buffer.
class ByteWriter {
 public:
  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof(T));
  }
  template <class T>
  void list(const std::vector<T>& list) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(static_cast<std::uint64_t>(list.size()));
    append(list.data(), list.size() * sizeof(T));
  }
  [[nodiscard]] std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::uint8_t> bytes_;
};

/// Takes them out again. Throws UserError where the buffer ends too early.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class T>
  [[nodiscard]] T value() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  template <class T>
  [[nodiscard]] std::vector<T> list() {
    const auto size = value<std::uint64_t>();
    if (size > rest_.size() / sizeof(T)) fail();
    std::vector<T> list;
    reserve_in_large_pages(list, size);
    list.resize(size);
    const auto bytes = take(size * sizeof(T));
    if (size > 0) std::memcpy(list.data(), bytes.data(), bytes.size());
    return list;
  }
  [[nodiscard]] std::span<const std::uint8_t> rest() const { return rest_; }

 private:
  [[noreturn]] static void fail() {
    throw UserError("the index of the map ends too early; remove it and build it again");
  }
  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > rest_.size()) fail();
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }
  std::span<const std::uint8_t> rest_;
};

}  // namespace honka
