#pragma once

#include <cmath>
#include <numbers>

namespace honka {

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] constexpr double deg_to_rad(double angle_deg) { return angle_deg * (kPi / 180.0); }
[[nodiscard]] constexpr double rad_to_deg(double angle_rad) { return angle_rad * (180.0 / kPi); }

/// The same direction in (−π, π].
[[nodiscard]] inline double wrap_to_pi(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

}  // namespace honka
