#pragma once

#include <cmath>

#include "algo/types/random.h"
#include "sim/world/recording.h"

namespace honka::test {

/// A sweep of the size and randomness of a real one: 16,875 shots over 210°, a third of them
/// misses, the rest at ranges that vary smoothly with noise, stems in patches.
inline sim::TruthfulSweep synthetic_sweep(std::int64_t index) {
  sim::TruthfulSweep result;
  result.sweep.index = index;
  result.sweep.start_time_s = 0.1 * static_cast<double>(index) + 1.0 / 3.0;
  result.sweep.start_azimuth_rad = 0.7;
  RandomStream random(7, "synthetic_sweep", {static_cast<std::uint64_t>(index)});
  constexpr int kFirings = 1055, kLasers = 16;
  for (int firing = 0; firing < kFirings; ++firing) {
    for (int laser = 0; laser < kLasers; ++laser) {
      Return r;
      r.time_offset_ns = static_cast<std::uint32_t>(55296 * firing + 2304 * laser);
      r.laser = static_cast<std::uint8_t>(laser);
      sim::ReturnTruth truth;
      const int patch = (firing / 9 + 31 * laser) % 7;
      if (patch > 1) {
        const double range = 12.0 + 8.0 * std::sin(0.01 * firing + laser) + 3.0 * patch;
        truth.range_m = static_cast<float>(range + 0.05 * random.uniform());
        truth.label = {patch > 3 ? firing / 9 : -1,
                       patch > 3 ? sim::Part::kStem : sim::Part::kGround};
        r.range_ticks =
            static_cast<std::uint16_t>((truth.range_m + 0.03 * random.normal()) / 0.002);
        r.reflectivity = static_cast<std::uint8_t>(20.0 + 30.0 * random.uniform());
      }
      result.sweep.returns.push_back(r);
      result.truth.push_back(truth);
    }
  }
  return result;
}

}  // namespace honka::test
