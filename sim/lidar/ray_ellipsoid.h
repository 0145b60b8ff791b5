#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/lidar/ray.h"
#include "sim/world/world.h"

namespace honka::sim {

/// An ellipsoid as stored for casting: 32 bytes.
struct PackedEllipsoid {
  float cx, cy, cz, yaw_cos;
  float hx, hy, hz, yaw_sin;
};

[[nodiscard]] inline PackedEllipsoid packed(const Ellipsoid& e) {
  return {static_cast<float>(e.centre_m.x()),    static_cast<float>(e.centre_m.y()),
          static_cast<float>(e.centre_m.z()),    static_cast<float>(std::cos(e.yaw_rad)),
          static_cast<float>(e.half_axes_m.x()), static_cast<float>(e.half_axes_m.y()),
          static_cast<float>(e.half_axes_m.z()), static_cast<float>(std::sin(e.yaw_rad))};
}

/// The ray in the frame in which the ellipsoid is the unit sphere; the direction is not unit there.
[[nodiscard]] inline Ray to_unit_sphere(const Ray& r, const PackedEllipsoid& e) {
  const double mx = r.ox - e.cx, my = r.oy - e.cy, mz = r.oz - e.cz;
  const double c = e.yaw_cos, s = e.yaw_sin;
  return {(c * mx + s * my) / e.hx,     (c * my - s * mx) / e.hy,     mz / e.hz,
          (c * r.dx + s * r.dy) / e.hx, (c * r.dy - s * r.dx) / e.hy, r.dz / e.hz};
}

/// Range of the nearest surface point in (near, far); kNoHit without one.
[[nodiscard]] inline double intersect(const Ray& r, const PackedEllipsoid& e, double near,
                                      double far) {
  const Ray s = to_unit_sphere(r, e);
  const double A = s.dx * s.dx + s.dy * s.dy + s.dz * s.dz;
  const double B = s.ox * s.dx + s.oy * s.dy + s.oz * s.dz;
  const double C = s.ox * s.ox + s.oy * s.oy + s.oz * s.oz - 1.0;
  const double discriminant = B * B - A * C;
  if (!(discriminant >= 0.0)) return kNoHit;
  const double q = -(B + std::copysign(std::sqrt(discriminant), B));
  double first = q / A, second = C / q;
  if (second < first) std::swap(first, second);
  if (first > near && first < far) return first;
  if (second > near && second < far) return second;
  return kNoHit;
}

/// Cosine between the ray and the surface's normal at range t, in [0, 1].
[[nodiscard]] inline double incidence_cosine(const Ray& r, const PackedEllipsoid& e, double t) {
  const Ray s = to_unit_sphere(r, e);
  // The normal's covector is p in the sphere's frame; back in space it is scaled by 1 / h.
  const double px = s.ox + t * s.dx, py = s.oy + t * s.dy, pz = s.oz + t * s.dz;
  const double nx = px / e.hx, ny = py / e.hy, nz = pz / e.hz;
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(length > 0.0)) return 1.0;
  return std::min(1.0, std::fabs(px * s.dx + py * s.dy + pz * s.dz) / length);
}

}  // namespace honka::sim
