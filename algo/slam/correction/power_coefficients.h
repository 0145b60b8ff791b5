#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "algo/slam/sparse_frame.h"
#include "algo/types/settings.h"

namespace honka {

/// How the shares u_l of a correction are spread over the frames between its ends.
enum class PowerCoefficient : std::uint8_t {
  kIndex,    ///< Nevalainen2021 Eq. 21
  kPath,     ///< §4.1, 1: length of the path so far
  kErrors,   ///< §4.1, 1: match errors so far
  kMetric,   ///< §4.1, 2: Nevalainen2021 Eq. 31
  kNearest,  ///< §4.1, 3: Nevalainen2021 Eq. 32
};

/// index | path | errors | metric | nearest, in this order.
[[nodiscard]] const std::vector<std::string>& power_coefficient_names();
/// HONKA_CHECKs that the name is one of these.
[[nodiscard]] PowerCoefficient power_coefficient(const std::string& name);

/// Weights of d(τ)² = a θ² + b |q|² in Eqs. 31–32, and how the least d of Eq. 32 is looked for.
struct MotionMetric {
  double a_m2 = 100.0;  ///< per rad²: a turn counts as the way of a point 10 m off
  double b = 1.0;
  std::int64_t nearest_steps = 40;  ///< parts of [0, 1] at whose ends d is tried
  bool nearest_refined = true;      ///< then between the neighbours of the least
};
void describe(SettingsVisitor& v, MotionMetric& s);

/// Shares of frames j … i (i − j + 1 numbers): 0 at j, 1 at i, between them in [0, 1].
/// `step_errors_m[l]` is e of the match of frames l and l + 1; read by kErrors alone. Where a
/// measure is zero over the whole stretch (no path, no errors, equal ends) the index stands in.
/// j < i < poses.
[[nodiscard]] std::vector<double> power_coefficients(const FramePoses& T_first_frame, std::size_t j,
                                                     std::size_t i, PowerCoefficient kind,
                                                     std::span<const double> step_errors_m,
                                                     const MotionMetric& metric);

}  // namespace honka
