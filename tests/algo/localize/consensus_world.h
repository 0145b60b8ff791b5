#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "algo/localize/consensus/consensus.h"
#include "algo/types/angles.h"
#include "algo/types/pose.h"
#include "algo/types/random.h"

namespace honka::test {

using Stems = std::vector<Eigen::Vector2d>;

/// n stems at 0.0367 a square metre, at least 1.5 m apart.
inline Stems forest(std::size_t n, std::uint64_t seed) {
  RandomStream stream(seed, "consensus_forest");
  const double width_m = std::sqrt(static_cast<double>(n) / 0.0367);
  Stems stems;
  while (stems.size() < n) {
    const double x = stream.uniform(0.0, width_m);
    const Eigen::Vector2d p(x, stream.uniform(0.0, width_m));
    bool free = true;
    for (const Eigen::Vector2d& q : stems) free = free && (p - q).squaredNorm() > 2.25;
    if (free) stems.push_back(p);
  }
  return stems;
}

/// Planted: 2.5 m × 2 m, jitter 0.2 m, one in five has died.
inline Stems rows(int side, std::uint64_t seed) {
  RandomStream stream(seed, "consensus_rows");
  Stems stems;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double x = 2.5 * i + stream.normal(0.0, 0.2);
      const double y = 2.0 * j + stream.normal(0.0, 0.2);
      if (stream.uniform() < 0.8) stems.emplace_back(x, y);
    }
  }
  return stems;
}

struct SightingSettings {
  double noise_m = 0.0;
  double missed = 0.0;
  double false_share = 0.0;
  double range_m = 30.0;
  double radial_bias_m = 0.0;  ///< true stems are listed so much too near
};

struct Sighting {
  Stems stems;
  Pose2 T_map_local;
};

/// What a sensor near the middle of the map lists in 210 degrees.
inline Sighting sight(const Stems& map, const SightingSettings& s, std::uint64_t id) {
  RandomStream stream(1, "consensus_sight", {id});
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : map) box.extend(p);
  Sighting seen;
  seen.T_map_local.translation_m.x() =
      box.center().x() + 0.2 * box.sizes().x() * stream.uniform(-1.0, 1.0);
  seen.T_map_local.translation_m.y() =
      box.center().y() + 0.2 * box.sizes().y() * stream.uniform(-1.0, 1.0);
  seen.T_map_local.yaw_rad = stream.uniform(-3.0, 3.0);
  const double half_view = deg_to_rad(105.0);
  for (const Eigen::Vector2d& p : map) {
    const Eigen::Vector2d q = seen.T_map_local.inverse() * p;
    if (q.norm() > s.range_m || std::abs(std::atan2(q.y(), q.x())) > half_view) continue;
    if (stream.uniform() < s.missed) continue;
    const Eigen::Vector2d listed = q * (1.0 - s.radial_bias_m / q.norm());
    const double dx = stream.normal(0.0, s.noise_m);
    seen.stems.emplace_back(listed.x() + dx, listed.y() + stream.normal(0.0, s.noise_m));
  }
  const double per_true = s.false_share / (1.0 - s.false_share);
  const auto count = static_cast<int>(per_true * static_cast<double>(seen.stems.size()));
  for (int k = 0; k < count; ++k) {
    const double range = s.range_m * std::sqrt(stream.uniform());
    const double bearing = half_view * stream.uniform(-1.0, 1.0);
    seen.stems.emplace_back(range * std::cos(bearing), range * std::sin(bearing));
  }
  return seen;
}

inline ConsensusMatcher consensus_of(const Stems& map) {
  return {std::make_shared<ConsensusIndex>(map), ConsensusSettings{}};
}

inline double shift_between(const Pose2& a, const Pose2& b) {
  return (a.translation_m - b.translation_m).norm();
}

/// Within 0.5 m and 2.5°.
inline bool is_right(const Pose2& estimate, const Pose2& truth) {
  return shift_between(estimate, truth) < 0.5 &&
         std::abs(wrap_to_pi(estimate.yaw_rad - truth.yaw_rad)) < deg_to_rad(2.5);
}

}  // namespace honka::test
