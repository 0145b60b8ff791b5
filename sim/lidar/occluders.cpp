#include "sim/lidar/occluders.h"

#include <algorithm>
#include <cmath>

#include "algo/types/angles.h"

namespace honka::sim {
namespace {

/// Widens a sector by the laser's turn within a firing and the footprint of a shot.
constexpr double kMargin_rad = 0.02;

struct Sector {
  double middle_rad, half_rad;
};

/// Manual azimuths (clockwise from x) under which a cone is seen from the origin.
Sector sector_of(const Cone& cone) {
  const Eigen::Vector2d a = cone.a_m.head<2>(), b = cone.b_m.head<2>();
  const double radius = 1.05 * std::max(cone.radius_a_m, cone.radius_b_m);
  const Eigen::Vector2d e = b - a;
  const double share =
      e.squaredNorm() > 0.0 ? std::clamp(-a.dot(e) / e.squaredNorm(), 0.0, 1.0) : 0;
  const double nearest = (a + share * e).norm();
  if (nearest <= radius) return {0.0, 2.0 * kPi};
  const double from = -std::atan2(a.y(), a.x());
  const double turn = wrap_to_pi(-std::atan2(b.y(), b.x()) - from);
  return {from + 0.5 * turn, 0.5 * std::fabs(turn) + std::asin(radius / nearest) + kMargin_rad};
}

}  // namespace

Occluders::Occluders(std::span<const Cone> in_lidar) {
  for (const Cone& cone : in_lidar) {
    const Sector sector = sector_of(cone);
    pieces_.push_back({packed(cone), cone.label, sector.middle_rad, sector.half_rad});
  }
  aimed_.reserve(pieces_.size());
}

void Occluders::aim(double azimuth_rad) {
  aimed_.clear();
  for (const Piece& piece : pieces_) {
    if (std::fabs(wrap_to_pi(azimuth_rad - piece.middle_rad)) <= piece.half_rad) {
      aimed_.push_back(&piece);
    }
  }
}

Hit Occluders::cast(const Ray& in_lidar, double far_m) const {
  Hit hit;
  double far = far_m;
  for (const Piece* piece : aimed_) {
    const double t = intersect(in_lidar, piece->cone, 0.0, far);
    if (t == kNoHit) continue;
    far = t;
    hit = {t, piece->label, incidence_cosine(in_lidar, piece->cone, t)};
  }
  return hit;
}

}  // namespace honka::sim
