#pragma once

#include <cstdint>
#include <optional>

namespace honka::eval {

/// The most memory that this process held since the meter was made, beyond what it held then. By
/// the kernel's count of resident pages, so other threads' memory counts too; nothing where the
/// kernel does not tell.
class MemoryMeter {
 public:
  MemoryMeter();
  [[nodiscard]] std::optional<std::int64_t> peak_bytes() const;

 private:
  std::optional<std::int64_t> at_start_;
};

}  // namespace honka::eval
