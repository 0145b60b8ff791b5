#pragma once

#include <limits>

namespace honka::sim {

/// A ray as Embree sees it, widened: origin and unit direction, any frame, metres.
struct Ray {
  double ox, oy, oz;
  double dx, dy, dz;
};

/// "No hit" of the exact intersections: beyond every range.
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

}  // namespace honka::sim
