#pragma once

#include <array>
#include <vector>

#include "algo/types/pose.h"
#include "sim/lidar/ray.h"
#include "sim/world/trajectory.h"

namespace honka::sim {

/// The pose of the lidar at each ray of one sweep: exact at knots 0.5 ms apart, the matrix blended
/// between them. For an angular speed ω and acceleration α a direction is off by at most
/// α τ² / 8 (3e-8 rad at 1 rad/s²) and its length by (ω τ)² / 8 (4e-9 at 0.35 rad/s).
class SweepPoses {
 public:
  static constexpr double kKnot_s = 0.5e-3;

  SweepPoses(const Trajectory& trajectory, double start_time_s, double duration_s);

  using Matrix34 = std::array<double, 12>;  ///< [R | t] by rows

  /// T_world_lidar at `offset_s` after the start, in [0, duration].
  [[nodiscard]] Matrix34 at(double offset_s) const;

 private:
  std::vector<Matrix34> knots_;
};

inline SweepPoses::Matrix34 SweepPoses::at(double offset_s) const {
  const double place = offset_s * (1.0 / kKnot_s);
  const auto knot = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(place));
  const double share = place - static_cast<double>(knot);
  const Matrix34& p = knots_[knot];
  const Matrix34& q = knots_[knot + 1];
  Matrix34 m;
  for (std::size_t i = 0; i < 12; ++i) m[i] = p[i] + share * (q[i] - p[i]);
  return m;
}

/// A ray given in the lidar frame, in the world.
[[nodiscard]] inline Ray to_world(const SweepPoses::Matrix34& m, const Ray& r) {
  return {m[0] * r.ox + m[1] * r.oy + m[2] * r.oz + m[3],
          m[4] * r.ox + m[5] * r.oy + m[6] * r.oz + m[7],
          m[8] * r.ox + m[9] * r.oy + m[10] * r.oz + m[11],
          m[0] * r.dx + m[1] * r.dy + m[2] * r.dz,
          m[4] * r.dx + m[5] * r.dy + m[6] * r.dz,
          m[8] * r.dx + m[9] * r.dy + m[10] * r.dz};
}

}  // namespace honka::sim
