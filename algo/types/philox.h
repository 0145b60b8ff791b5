#pragma once

#include <Random123/philox.h>

#include <array>
#include <cstdint>

namespace honka {

/// One block of Philox4x32-10 (Salmon et al. 2011): 128 random bits that belong to (key, counter).
/// Inline, for the one draw a ray; elsewhere RandomStream.
[[nodiscard]] inline std::array<std::uint32_t, 4> philox_block(
    const std::array<std::uint32_t, 2>& key, const std::array<std::uint32_t, 4>& counter) {
  const r123::Philox4x32::ctr_type c{{counter[0], counter[1], counter[2], counter[3]}};
  const r123::Philox4x32::key_type k{{key[0], key[1]}};
  const auto block = r123::Philox4x32{}(c, k);
  return {block[0], block[1], block[2], block[3]};
}

}  // namespace honka
