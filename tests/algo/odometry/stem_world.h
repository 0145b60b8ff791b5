#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "algo/geometry/se3.h"
#include "algo/types/lidar_model.h"
#include "algo/types/pose.h"
#include "algo/types/random.h"
#include "algo/types/sweep.h"

/// Upright or leaning cylinders on a plane, and what a lidar sees of them: every range is on paper.
namespace honka::stem_world {

struct Trunk {
  Eigen::Vector2d foot_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();  ///< x and y per metre of z
  double radius_m = 0.12;                          ///< at z = 0
  double taper = 0.0;                              ///< loss of radius per metre of z
};

struct World {
  std::vector<Trunk> trunks;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< of the ground: z = slope · (x, y)
  bool ground = true;
};

/// T_world_lidar at a time.
using Way = std::function<Pose3(double)>;

/// Least range at which a ray meets the world; infinite when it meets nothing.
inline double cast(const World& world, const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  double best = std::numeric_limits<double>::infinity();
  if (world.ground) {
    const Eigen::Vector3d n(-world.slope.x(), -world.slope.y(), 1.0);
    const double range = -n.dot(from) / n.dot(along);
    if (range > 0.0) best = range;
  }
  const double x = from.x(), y = from.y(), z = from.z();
  const double dx = along.x(), dy = along.y(), dz = along.z();
  // Plain numbers, because sanitizers watch every call that Eigen would make a million times.
  for (const Trunk& trunk : world.trunks) {
    // |p − axis(z)|² = r(z)² in the plane, p = from + s · along.
    const double *foot = trunk.foot_m.data(), *lean = trunk.lean.data();
    const double ax = x - foot[0] - z * lean[0], ay = y - foot[1] - z * lean[1];
    const double bx = dx - dz * lean[0], by = dy - dz * lean[1];
    const double r = trunk.radius_m - trunk.taper * z, dr = -trunk.taper * dz;
    const double A = bx * bx + by * by - dr * dr, B = ax * bx + ay * by - r * dr;
    const double C = ax * ax + ay * ay - r * r;
    const double D = B * B - A * C;
    if (D < 0.0) continue;
    const double range = (-B - std::sqrt(D)) / A;
    if (range > 0.0 && range < best) best = range;
  }
  return best;
}

/// One revolution that starts at `start_s`; behind ±105° the cabin is in the way.
inline Sweep scan(const World& world, const LidarModel& model, const Way& way, std::int64_t index,
                  double start_s, double noise_m = 0.0) {
  Sweep sweep;
  sweep.index = index;
  sweep.start_time_s = start_s;
  sweep.start_azimuth_rad = -kPi;
  RandomStream random(1, "stem_world_noise", {static_cast<std::uint64_t>(index)});
  const auto firings = static_cast<int>(model.sweep_period_s() / model.firing_period_s);
  for (int firing = 0; firing < firings; ++firing) {
    const double share = (firing + 0.5) / firings;
    if (std::abs(share - 0.5) > 105.0 / 360.0) continue;
    const Pose3 T_world_lidar = way(start_s + firing * model.firing_period_s);
    for (std::size_t laser = 0; laser < model.lasers.size(); ++laser) {
      Return r;
      r.time_offset_ns = static_cast<std::uint32_t>(std::lround(
          1e9 * (firing * model.firing_period_s + model.lasers[laser].firing_offset_s)));
      r.laser = static_cast<std::uint8_t>(laser);
      const Eigen::Vector3d along =
          T_world_lidar.linear() *
          model.direction(static_cast<int>(laser), sweep.azimuth_rad(r, model));
      const double range_m = cast(world, T_world_lidar.translation(), along) +
                             (noise_m > 0.0 ? noise_m * random.normal() : 0.0);
      if (range_m > 0.5 && range_m < model.max_range_m) {
        r.range_ticks = static_cast<std::uint16_t>(std::lround(range_m / model.range_resolution_m));
      }
      sweep.returns.push_back(r);
    }
  }
  return sweep;
}

/// Trees on a jittered lattice, none within 3 m of the x axis.
inline World stand(int half_count = 5, double lean_sigma = 0.0, std::uint64_t seed = 1) {
  World world;
  RandomStream random(seed, "stem_world_stand");
  for (int ix = -half_count; ix <= half_count; ++ix) {
    for (int iy = -half_count; iy <= half_count; ++iy) {
      Trunk trunk;
      trunk.foot_m = {5.0 * ix + random.uniform(-1.5, 1.5), 5.0 * iy + random.uniform(-1.5, 1.5)};
      trunk.radius_m = random.uniform(0.08, 0.18);
      trunk.lean = {lean_sigma * random.normal(), lean_sigma * random.normal()};
      if (std::abs(trunk.foot_m.y()) > 3.0) world.trunks.push_back(trunk);
    }
  }
  return world;
}

/// Turned about the z axis as a whole.
inline World turned(const World& world, double yaw_rad) {
  World other = world;
  const Eigen::Rotation2Dd turn(yaw_rad);
  for (Trunk& trunk : other.trunks) {
    trunk.foot_m = turn * trunk.foot_m;
    trunk.lean = turn * trunk.lean;
  }
  other.slope = turn * world.slope;
  return other;
}

/// A drive with constant body twist (per second) from a pose.
inline Way steady(const Pose3& T_world_start, const Twist& per_second) {
  return [=](double t) -> Pose3 { return T_world_start * se3_exp(per_second * t); };
}

}  // namespace honka::stem_world
