#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "algo/types/philox.h"

namespace honka::sim {

/// The random numbers of one shot, a hash of (seed, sweep, firing, laser): one Philox block.
struct ShotNoise {
  std::uint32_t drop_out;
  std::array<std::uint32_t, 2> range;  ///< of the first and of the second echo
};

[[nodiscard]] inline ShotNoise shot_noise(std::uint64_t key, std::uint64_t sweep,
                                          std::uint32_t firing, std::uint32_t laser) {
  const auto block = philox_block(
      {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U)},
      {static_cast<std::uint32_t>(sweep), static_cast<std::uint32_t>(sweep >> 32U), firing, laser});
  return {block[0], {block[1], block[2]}};
}

/// In (0, 1), 32 bits.
[[nodiscard]] inline double uniform_of(std::uint32_t bits) { return (bits + 0.5) * 0x1.0p-32; }

/// Standard normal by the inverse of its distribution, to 1e-7 (Wichura 1988, AS 241, PPND7): no
/// trigonometry, and no logarithm for 85 % of the draws.
[[nodiscard]] inline double normal_of(std::uint32_t bits) {
  const double p = uniform_of(bits);
  const double q = p - 0.5;
  if (std::fabs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q *
           (((5.9109374720e+1 * r + 1.5929113202e+2) * r + 5.0434271938e+1) * r + 3.3871327179) /
           (((6.7187563600e+1 * r + 7.8757757664e+1) * r + 1.7895169469e+1) * r + 1.0);
  }
  const double r = std::sqrt(-std::log(q < 0.0 ? p : 1.0 - p));
  double value;
  if (r <= 5.0) {
    const double s = r - 1.6;
    value = (((1.7023821103e-1 * s + 1.3067284816) * s + 2.7568153900) * s + 1.4234372777) /
            ((1.2021132975e-1 * s + 7.3700164250e-1) * s + 1.0);
  } else {
    const double s = r - 5.0;
    value = (((1.7337203997e-2 * s + 4.2868294337e-1) * s + 3.0812263860) * s + 6.6579051150) /
            ((1.2258202635e-2 * s + 2.4197894225e-1) * s + 1.0);
  }
  return q < 0.0 ? -value : value;
}

}  // namespace honka::sim
