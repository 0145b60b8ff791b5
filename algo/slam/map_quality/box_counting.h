#pragma once

#include <Eigen/Core>
#include <span>

#include "algo/types/settings.h"

namespace honka {

/// The boxes that a dimension is read from: `smallest_m`, doubled up to `largest_m`.
struct BoxCountingSettings {
  double smallest_m = 0.2;
  double largest_m = 3.2;
  bool spatial = false;
};
void describe(SettingsVisitor& v, BoxCountingSettings& s);

/// The box-counting dimension: the least-squares slope of ln(occupied boxes) over ln(1 / size). A
/// curve has 1, a filled area 2, points farther apart than the largest box 0. 0 for an empty map.
[[nodiscard]] double box_dimension(std::span<const Eigen::Vector3d> map_m,
                                   const BoxCountingSettings& settings);

/// The same from two sizes alone, those of the blur: it rises and falls with β.
[[nodiscard]] double two_scale_dimension(std::span<const Eigen::Vector3d> map_m, double fine_m,
                                         double coarse_m, bool spatial = false);

}  // namespace honka
