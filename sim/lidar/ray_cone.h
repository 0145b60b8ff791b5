#pragma once

#include <algorithm>
#include <cmath>

#include "sim/lidar/ray.h"
#include "sim/world/world.h"

namespace honka::sim {

/// A cone as stored for casting: 32 bytes, two in a cache line. Chained cones share their corners'
/// digits, so that no ray passes between them.
struct PackedCone {
  float ax, ay, az, ra;
  float bx, by, bz, rb;
};

/// How far a cone's mantle reaches beyond its discs, in radii there: closes the wedge that a bend
/// of up to 2.3° leaves open between two chained cones.
inline constexpr double kJointOverlap = 0.02;

[[nodiscard]] inline PackedCone packed(const Cone& c) {
  return {static_cast<float>(c.a_m.x()), static_cast<float>(c.a_m.y()),
          static_cast<float>(c.a_m.z()), static_cast<float>(c.radius_a_m),
          static_cast<float>(c.b_m.x()), static_cast<float>(c.b_m.y()),
          static_cast<float>(c.b_m.z()), static_cast<float>(c.radius_b_m)};
}

/// Range of the nearest mantle point in (near, far) along the ray; kNoHit without one. Exact up to
/// double rounding, from outside and from inside, also along the axis.
///
/// With m = o − a, e = b − a and u = (m·e + t d·e) / e·e, the mantle is
/// |m + t d|² − u² e·e = (ra + u (rb − ra))², a quadratic A t² + 2 B t + C in t.
[[nodiscard]] inline double intersect(const Ray& r, const PackedCone& c, double near, double far) {
  const double ax = c.ax, ay = c.ay, az = c.az, ra = c.ra;
  const double ex = c.bx - ax, ey = c.by - ay, ez = c.bz - az, dr = c.rb - ra;
  const double mx = r.ox - ax, my = r.oy - ay, mz = r.oz - az;
  const double inverse_ee = 1.0 / (ex * ex + ey * ey + ez * ez);
  const double me = mx * ex + my * ey + mz * ez;
  const double de = r.dx * ex + r.dy * ey + r.dz * ez;
  const double u_rate = de * inverse_ee;
  const double u_origin = me * inverse_ee;
  const double r_rate = dr * u_rate;
  const double r_origin = ra + dr * u_origin;
  const double A = (r.dx * r.dx + r.dy * r.dy + r.dz * r.dz) - de * u_rate - r_rate * r_rate;
  const double B = (mx * r.dx + my * r.dy + mz * r.dz) - me * u_rate - r_rate * r_origin;
  const double C = (mx * mx + my * my + mz * mz) - me * u_origin - r_origin * r_origin;
  const double discriminant = B * B - A * C;
  if (!(discriminant >= 0.0)) return kNoHit;
  // The stable pair of roots; a vanishing A leaves the second one finite.
  const double q = -(B + std::copysign(std::sqrt(discriminant), B));
  const double t1 = q / A;
  const double t2 = C / q;
  const double overlap = kJointOverlap * std::sqrt(inverse_ee);
  const double u_low = -overlap * ra;
  const double u_high = 1.0 + overlap * c.rb;
  const auto valid = [&](double t) {
    const double u = u_origin + t * u_rate;
    return t > near && t < far && u >= u_low && u <= u_high;
  };
  double nearest = kNoHit;
  if (valid(t1)) nearest = t1;
  if (valid(t2) && t2 < nearest) nearest = t2;
  return nearest;
}

/// Cosine between the ray and the mantle's normal at range t, in [0, 1].
[[nodiscard]] inline double incidence_cosine(const Ray& r, const PackedCone& c, double t) {
  const double ex = double{c.bx} - c.ax, ey = double{c.by} - c.ay, ez = double{c.bz} - c.az;
  const double px = r.ox + t * r.dx - c.ax, py = r.oy + t * r.dy - c.ay,
               pz = r.oz + t * r.dz - c.az;
  const double ee = ex * ex + ey * ey + ez * ez;
  const double u = (px * ex + py * ey + pz * ez) / ee;
  // Gradient of |p − u e| − r(u).
  const double radius = c.ra + u * (double{c.rb} - c.ra);
  const double lean = radius * (double{c.rb} - c.ra) / ee;
  const double nx = px - (u + lean) * ex, ny = py - (u + lean) * ey, nz = pz - (u + lean) * ez;
  const double length = std::sqrt(nx * nx + ny * ny + nz * nz);
  if (!(length > 0.0)) return 1.0;
  return std::min(1.0, std::fabs(nx * r.dx + ny * r.dy + nz * r.dz) / length);
}

}  // namespace honka::sim
