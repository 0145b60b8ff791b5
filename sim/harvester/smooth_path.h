#pragma once

#include "sim/world/polyline.h"

namespace honka::sim {

/// A polyline as a twice differentiable curve: a uniform cubic B-spline over its points every half
/// metre, straight on beyond both ends. Straight lines stay as they are; a bend of radius 10 m is
/// cut by 4 mm.
class SmoothPath {
 public:
  explicit SmoothPath(const Polyline& line);

  [[nodiscard]] double length_m() const { return length_m_; }
  /// The place `along_m` from the start, any real number.
  [[nodiscard]] Eigen::Vector2d at(double along_m) const;

 private:
  [[nodiscard]] Eigen::Vector2d control(std::ptrdiff_t i) const;

  Polyline points_;
  double length_m_ = 0.0;
  double step_m_ = 1.0;
};

}  // namespace honka::sim
